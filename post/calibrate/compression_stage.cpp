#include "post/calibrate/compression_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "post/calibrate/surface.hpp"

namespace graincrack::calibrate {

namespace {

constexpr double degree = std::numbers::pi / 180;

WantedRun rectangle(const Progress& progress, const Point& point, std::int64_t seed, bool confined, const std::string& reason) {
    const double pressure = confined ? progress.target(confined_strength).confining_pressure : 0;
    return {confined ? "triaxial" : "uniaxial", pressure, seed, point, std::nullopt, reason};
}

Point at(const Point& point, const Place& place) {
    return point.with(Parameter::cohesion, place[0]).with(Parameter::friction_angle, place[1]);
}
Place place_of(const Point& point) { return {*point[Parameter::cohesion], *point[Parameter::friction_angle]}; }

double bounded(const Progress& progress, Parameter parameter, double value) {
    const Range range = range_of(parameter, progress.rock(), progress.decision.point, progress.study().specimens.mean_edge());
    return std::clamp(value, range.low, range.high);
}
Place bounded(const Progress& progress, const Place& place) {
    return {bounded(progress, Parameter::cohesion, place[0]), bounded(progress, Parameter::friction_angle, place[1])};
}

/// φ of the line through both strengths; 0 where they do not rise.
double friction_angle(double uniaxial, double confined, double pressure) {
    const double b = std::max(1.0, (confined - uniaxial) / pressure);
    return std::asin((b - 1) / (b + 1));
}

std::string label_of(const Place& place) {
    return fmt::format("cc {}, φc {}", label_of(Parameter::cohesion, place[0]), label_of(Parameter::friction_angle, place[1]));
}

/// Specimens at places, each with both tests. \throws RunsMissing
std::vector<SurfacePoint> test_places(const Progress& progress, const std::vector<Place>& places, std::int64_t first_seed,
                                      const std::string& reason) {
    const double ucs = progress.target("compressive_strength").value;
    const double confined = progress.target(confined_strength).value;
    std::vector<WantedRun> wanted;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Point point = at(progress.decision.point, bounded(progress, places[i]));
        for (const bool under_pressure : {true, false})
            wanted.push_back(rectangle(progress, point, first_seed + static_cast<std::int64_t>(i), under_pressure, reason));
    }
    const auto runs = progress.get(wanted);
    std::vector<SurfacePoint> out;
    for (std::size_t i = 0; i < places.size(); ++i) {
        out.push_back({place_of(wanted[2 * i].point), {runs[2 * i + 1].strength / ucs, runs[2 * i].strength / confined}});
    }
    return out;
}

void note_solution(Progress& progress, const std::string& what, const SurfaceSolution& solution, std::size_t n) {
    std::string fit;
    for (const auto& p : solution.lack_of_fit_p) fit += p ? fmt::format(", lack of fit p {:.2g}", *p) : "";
    progress.note(
        "cc, φc", fmt::format("{}: {} specimens{}", what, n, fit),
        fmt::format("{} {}: UCS {:.4g} MPa, {} {:.4g} MPa", solution.met ? "both met at" : "nearest place",
                    label_of(solution.place), solution.expected[0] * progress.target("compressive_strength").value * 1e-6,
                    progress.target(confined_strength).symbol,
                    solution.expected[1] * progress.target(confined_strength).value * 1e-6));
}

/// Each strength has been on both sides of its target, or on it: alone it is in reach.
bool each_in_reach(const std::vector<SurfacePoint>& points) {
    for (std::size_t i = 0; i < 2; ++i) {
        const auto [low, high] = std::minmax_element(
            points.begin(), points.end(), [&](const auto& a, const auto& b) { return a.over_target[i] < b.over_target[i]; });
        if (low->over_target[i] > 1 || high->over_target[i] < 1) return false;
    }
    return true;
}

[[noreturn]] void end_unmet(Progress& progress, const SurfaceSolution& solution, const std::vector<SurfacePoint>& points) {
    progress.decision.point = at(progress.decision.point, solution.place);
    const bool contradictory = each_in_reach(points);
    std::string off;
    const std::array<const Target*, 2> both{&progress.target("compressive_strength"), &progress.target(confined_strength)};
    for (std::size_t i = 0; i < 2; ++i) {
        off += fmt::format("{}{} {:.4g} MPa, {:+.1f} % off", i == 0 ? "" : " and ", both[i]->symbol,
                           solution.expected[i] * both[i]->value * 1e-6, 100 * (solution.expected[i] - 1));
        progress.decision.outcomes.push_back({*both[i], Estimate{solution.expected[i] * both[i]->value, {}, {}}, points.size(),
                                              std::abs(solution.expected[i] - 1) <= both[i]->bound ? "within" : "outside",
                                              "by the surfaces of the last design"});
    }
    throw Ended{
        contradictory ? Ending::contradictory : Ending::not_reached,
        fmt::format(
            "UCS {:.4g} MPa and {} {:.4g} MPa are out of reach{}: the nearest point is {}, with {}; designs moved {} times",
            both[0]->value * 1e-6, both[1]->symbol, both[1]->value * 1e-6,
            contradictory ? " together, though each is reached alone" : "", label_of(solution.place), off,
            progress.study().moves)};
}

/// Rows of seeds of the designs of a round.
std::int64_t design_seed(std::size_t round, std::size_t design) {
    return seeds::designs + static_cast<std::int64_t>(round) * seeds::per_round + static_cast<std::int64_t>(design) * 40;
}

/// Designs of one round, in the frame of the first.
class Designs {
public:
    Designs(Progress& progress, std::size_t round)
        : progress_(progress),
          round_(round),
          frame_{place_of(progress.decision.point), progress.study().design_factor,
                 progress.study().design_angle * progress.laboratory("friction_angle")} {
        solution_.place = frame_.centre;
    }

    /// Adds a design about the solution, `scale` times as wide as the first, and moves it to the nearest place until both targets
    /// lie inside. \throws RunsMissing, Ended
    void add(double scale, const std::string& reason) {
        for (std::size_t move = 0; move <= progress_.study().moves; ++move) {
            const Frame here{bounded(progress_, solution_.place), frame_.factor, frame_.angle};
            const auto more = test_places(progress_, design_places(here, scale, progress_.study().centre_runs),
                                          design_seed(round_, designs_++), reason);
            if (scale == 1) frame_ = here;
            points_.insert(points_.end(), more.begin(), more.end());
            solve(fmt::format("design about {}, {:g} times as wide", label_of(here.centre), scale));
            if (solution_.met) return;
        }
        end_unmet(progress_, solution_, points_);
    }

    /// Specimens at the solution, until both means are narrow enough. \throws RunsMissing
    void replicate() {
        const SamplingRule& rule = progress_.study().rectangles;
        const Place place = place_of(at(progress_.decision.point, bounded(progress_, solution_.place)));
        const std::int64_t first = seeds::replicates + static_cast<std::int64_t>(round_) * seeds::per_round;
        std::vector<SurfacePoint> more;
        for (std::size_t n = 0, wanted = std::min(rule.least, rule.most); n < wanted;) {
            n = wanted;
            more = test_places(progress_, std::vector<Place>(n, place), first, "UCS and strength under pressure at the optimum");
            for (std::size_t i = 0; i < 2; ++i) {
                std::vector<double> values;
                for (const SurfacePoint& p : more) values.push_back(p.over_target[i]);
                wanted = std::max(wanted, specimens_wanted(values, rule));
            }
        }
        solution_ = correct_by_replicates(frame_, near_points(), more);
        points_.insert(points_.end(), more.begin(), more.end());
        note_solution(progress_, fmt::format("with {} specimens at {}", more.size(), label_of(place)), solution_, points_.size());
    }

    [[nodiscard]] const SurfaceSolution& solution() const { return solution_; }

private:
    /// The points of the present design and those near it: a quadratic fits no farther.
    [[nodiscard]] std::vector<SurfacePoint> near_points() const {
        constexpr double near = 2.5;  // coded; the corners of a design of width 1 lie at 1.4
        std::vector<SurfacePoint> close;
        for (const SurfacePoint& point : points_) {
            const std::vector<double> coded = frame_.coded(point.place);
            if (std::hypot(coded[0], coded[1]) <= near) close.push_back(point);
        }
        return close;
    }
    void solve(const std::string& what) {
        const std::vector<SurfacePoint> close = near_points();
        solution_ = solve_surfaces(frame_, close);
        note_solution(progress_, what, solution_, close.size());
    }

    Progress& progress_;
    std::size_t round_;
    Frame frame_;
    std::vector<SurfacePoint> points_;
    SurfaceSolution solution_;
    std::size_t designs_ = 0;
};

}  // namespace

void find_start(Progress& progress) {
    const Target& ucs = progress.target("compressive_strength");
    const Target& confined = progress.target(confined_strength);
    const double wanted = friction_angle(ucs.value, confined.value, confined.confining_pressure);
    std::optional<std::pair<double, double>> below;  // φc and φ
    std::optional<std::pair<double, double>> above;
    Point& point = progress.decision.point;
    for (std::size_t attempt = 0; attempt < progress.study().scouts; ++attempt) {
        const std::string reason = "single tests, to get near UCS and φ";
        const auto runs = progress.get(
            {rectangle(progress, point, seeds::near, true, reason), rectangle(progress, point, seeds::near, false, reason)});
        const double strength = runs[1].strength;
        const double angle = friction_angle(strength, runs[0].strength, confined.confining_pressure);
        const double phic = *point[Parameter::friction_angle];
        progress.note("start", label_of(place_of(point)),
                      fmt::format("one specimen: UCS {:.4g} MPa, {} {:.4g} MPa: φ {:.3g}°", strength * 1e-6, confined.symbol,
                                  runs[0].strength * 1e-6, angle / degree));
        if (std::abs(strength / ucs.value - 1) <= 0.1 && std::abs(angle - wanted) <= 3 * degree) break;
        // UCS is nearly proportional to cc, and φ increases with φc.
        const double cc = *point[Parameter::cohesion] * std::clamp(ucs.value / strength, 0.5, 2.0);
        (angle < wanted ? below : above) = {phic, angle};
        double next = phic + std::clamp(wanted - angle, -8 * degree, 8 * degree);
        if (below && above && above->second > below->second) {
            next = below->first + (above->first - below->first) * (wanted - below->second) / (above->second - below->second);
        }
        point = point.with(Parameter::cohesion, bounded(progress, Parameter::cohesion, cc))
                    .with(Parameter::friction_angle, bounded(progress, Parameter::friction_angle, next));
    }
}

void fit_compression(Progress& progress, std::size_t round) {
    Designs designs(progress, round);
    designs.add(1, "a design for cc and φc");
    designs.add(progress.study().narrow, "a narrower design for cc and φc");
    designs.replicate();
    if (!designs.solution().met) designs.add(progress.study().narrow, "a narrower design for cc and φc");
    const SurfaceSolution& solution = designs.solution();
    progress.decision.point = at(progress.decision.point, bounded(progress, solution.place));
    std::erase_if(progress.decision.values, [](const Calibrated& c) {
        return c.parameter == Parameter::cohesion || c.parameter == Parameter::friction_angle;
    });
    progress.decision.values.push_back({Parameter::cohesion, solution.interval[0]});
    progress.decision.values.push_back({Parameter::friction_angle, solution.interval[1]});
}

}  // namespace graincrack::calibrate
