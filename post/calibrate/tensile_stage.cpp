#include "post/calibrate/tensile_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "post/calibrate/search.hpp"

namespace graincrack::calibrate {

namespace {

/// tc is the parameter of σt only if σt follows it clearly: below, its value would have twice the relative interval of σt.
constexpr double identifiable = 0.5;
/// σt is met within this part, and the search ends where its steps are smaller than `small_step`.
constexpr double near = 0.02;
constexpr double small_step = 0.03;

WantedRun disc(const Point& point, const std::string& reason) { return {"brazilian", 0, 0, point, std::nullopt, reason}; }

/// A parameter tried alone: its levels, and the trend of σt.
struct Trial {
    TensilePath::Member member;
    Levels levels;  ///< against ln value/start
    Estimate slope;
    [[nodiscard]] bool moves() const { return slope.value > 0 && slope.low.value_or(slope.value) > 0; }
};

TensilePath path_of(const TensilePath::Member& member, double slope) {
    return {{member}, std::log(member.low / member.start), std::log(member.high / member.start), slope};
}

Trial try_parameter(Progress& progress, Parameter parameter, const Point& base) {
    const Study& study = progress.study();
    const double start = first_guess(parameter, progress.rock(), base, study.specimens.mean_edge());
    const Range range = range_of(parameter, progress.rock(), base, study.specimens.mean_edge());
    Trial trial{{parameter, start, 1, range.low, range.high}, {}, {}};
    const TensilePath alone = path_of(trial.member, 1);
    std::vector<double> ways;
    for (const double share : {0.5, 1.0, 2.0}) {
        const double way = std::clamp(std::log(share), alone.low, alone.high);
        if (std::find(ways.begin(), ways.end(), way) == ways.end()) ways.push_back(way);
    }
    const auto reason = fmt::format("how σt follows {}", row_of(parameter).symbol);
    std::vector<WantedRun> wanted;
    for (const double way : ways) {
        WantedRun run = disc(alone.point(progress.rock(), base, way), reason);
        for (std::size_t i = 0; i < study.scan_discs; ++i) {
            run.seed = seeds::near + static_cast<std::int64_t>(i);
            wanted.push_back(run);
        }
    }
    const std::vector<double> results = strengths_of(progress.get(wanted));
    std::string means;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const auto from = results.begin() + static_cast<std::ptrdiff_t>(i * study.scan_discs);
        trial.levels.add(ways[i], {from, from + static_cast<std::ptrdiff_t>(study.scan_discs)});
        means += fmt::format("{}{:.4g} MPa at {}", means.empty() ? "" : ", ", trial.levels.mean_at(ways[i]) * 1e-6,
                             label_of(parameter, start * std::exp(ways[i])));
    }
    trial.slope = trial.levels.slope().value_or(Estimate{});
    progress.note("σt",
                  fmt::format("d ln σt/d ln {} = {:.3g} ({:.3g} to {:.3g})", row_of(parameter).symbol, trial.slope.value,
                              trial.slope.low.value_or(NAN), trial.slope.high.value_or(NAN)),
                  means);
    return trial;
}

/// Where along its bounds a single parameter meets the target; empty if outside.
std::optional<double> place_of(const Trial& trial, double target) {
    if (!trial.moves()) return std::nullopt;
    const TensilePath path = path_of(trial.member, trial.slope.value);
    const double way = trial.levels.crossing(target, trial.slope.value);
    if (way < path.low || way > path.high) return std::nullopt;
    return way;
}

/// All parameters that move σt go to their bounds together, from their starts at 0: each by ln of its bound over its start, at 1.
/// The way goes on backwards, as cc and φc may take σt beyond its target.
TensilePath together(const std::vector<Trial>& trials, bool rise) {
    TensilePath path{{}, -1, 1, 0};
    for (const Trial& trial : trials) {
        if (!trial.moves()) continue;
        TensilePath::Member member = trial.member;
        member.rate = std::log((rise ? member.high : member.low) / member.start);
        path.members.push_back(member);
        path.slope += trial.slope.value * member.rate;
    }
    return path;
}

/// The search along a path on the same discs, until σt is near its target or the steps are small. Empty if it leads beyond the
/// ends.
std::optional<double> search(Progress& progress, TensilePath& path, Levels levels, double way) {
    const double target = progress.target("tensile_strength").value;
    for (int attempt = 0; attempt < 6; ++attempt) {
        const Point point = path.point(progress.rock(), progress.decision.point, way);
        if (!levels.has(way)) {
            levels.add(way, strengths_of(progress.get(disc(point, "the place where σt is met"), seeds::near,
                                                      progress.study().scan_discs)));
            progress.note("σt", label_of(point), fmt::format("σt {:.4g} MPa", levels.mean_at(way) * 1e-6));
        }
        if (std::abs(std::log(levels.mean_at(way) / target)) <= near) return way;
        const double next = levels.crossing(target, path.slope);
        const bool at_end = (way >= path.high && next > path.high) || (way <= path.low && next < path.low);
        if (at_end) return std::nullopt;
        const double place = std::clamp(next, path.low, path.high);
        if (std::abs(place - way) * std::abs(path.slope) < small_step * 0.1) return place;
        way = place;
    }
    return levels.nearest(target);
}

std::string symbols_of(const TensilePath& path) {
    std::string text;
    for (const auto& member : path.members)
        text += fmt::format("{}{}", text.empty() ? "" : " and ", row_of(member.parameter).symbol);
    return text;
}

[[noreturn]] void end_out_of_reach(Progress& progress, const std::vector<Trial>& trials, const TensilePath& path) {
    const Target& target = progress.target("tensile_strength");
    if (path.members.empty()) {
        throw Ended{Ending::undecided,
                    fmt::format("σt does not follow tc, Gf or the shear strength of open contacts above the scatter of "
                                "{} discs",
                                progress.study().scan_discs)};
    }
    const Point nearest = path.point(progress.rock(), progress.decision.point, 1);
    const auto runs = progress.sampled(disc(nearest, "σt where all its parameters are at their bounds"), seeds::final_discs,
                                       progress.study().discs);
    const Sample there = sample(strengths_of(runs));
    progress.decision.point = nearest;
    progress.decision.outcomes.push_back({target, there.mean, there.n, "outside", ""});
    throw Ended{
        Ending::not_reached,
        fmt::format(
            "σt {:.4g} MPa is out of reach: with {} at their bounds ({}) it is {:.4g} MPa, {:+.1f} % off; {} were tried alone "
            "and together",
            target.value * 1e-6, symbols_of(path), label_of(nearest), there.mean.value * 1e-6,
            100 * (there.mean.value / target.value - 1), trials.size())};
}

}  // namespace

Point TensilePath::point(const Material& rock, const Point& base, double way) const {
    Point point = base;
    std::optional<double> share;  // of the open shear strength that tc implies
    for (const Member& member : members) {
        const double value = std::clamp(member.start * std::exp(member.rate * way), member.low, member.high);
        if (member.parameter == Parameter::open_shear_strength) {
            share = value / member.start;
        } else {
            point = point.with(member.parameter, value);
        }
    }
    if (share) {
        point[Parameter::open_shear_strength].reset();
        const double usual = first_guess(Parameter::open_shear_strength, rock, point, 0);
        point = point.with(Parameter::open_shear_strength, usual * *share);
    }
    return point;
}

TensilePath find_tensile_path(Progress& progress, double& way) {
    const Point base = progress.decision.point;
    const double target = progress.target("tensile_strength").value;
    const auto take = [&](TensilePath path, const Levels& levels, double start) -> std::optional<TensilePath> {
        const auto place = search(progress, path, levels, start);
        if (!place) return std::nullopt;
        way = *place;
        progress.decision.point = path.point(progress.rock(), base, way);
        progress.note("σt", "calibration parameter: " + symbols_of(path), label_of(progress.decision.point));
        return path;
    };
    std::vector<Trial> trials;
    for (const Parameter p : {Parameter::tensile_strength, Parameter::fracture_energy, Parameter::open_shear_strength}) {
        trials.push_back(try_parameter(progress, p, base));
        const Trial& trial = trials.back();
        if (p == Parameter::tensile_strength && trial.slope.value < identifiable) {
            progress.note("σt", "not by tc alone", "tc is not identifiable from σt");
            continue;
        }
        const auto place = place_of(trial, target);
        if (place) {
            if (auto path = take(path_of(trial.member, trial.slope.value), trial.levels, *place)) return *path;
        }
        progress.note("σt", fmt::format("not by {} alone", row_of(p).symbol),
                      trial.moves() ? "outside its bounds" : "σt does not follow it");
    }
    const bool rise = trials.front().levels.mean_at(0) < target;
    const TensilePath path = together(trials, rise);
    if (path.members.empty()) end_out_of_reach(progress, trials, path);
    Levels none;
    none.add(0, strengths_of(progress.get(disc(base, "the place where σt is met"), seeds::near, progress.study().scan_discs)));
    const double start = std::clamp(none.crossing(target, path.slope), 0.0, 1.0);
    if (auto found = take(path, none, start)) return *found;
    end_out_of_reach(progress, trials, path);
}

void adjust_tensile(Progress& progress, TensilePath& path, double& way, std::int64_t first_seed) {
    const double target = progress.target("tensile_strength").value;
    const Point base = progress.decision.point;
    Levels levels;
    std::size_t n = 0;
    double half = 0;
    for (int attempt = 0; attempt < 5; ++attempt) {
        const Point point = path.point(progress.rock(), base, way);
        const WantedRun run = disc(point, "σt at the present cc and φc");
        const auto runs =
            attempt == 0 ? progress.sampled(run, first_seed, progress.study().discs) : progress.get(run, first_seed, n);
        n = runs.size();
        half = relative_half_interval(strengths_of(runs)).value_or(0);
        levels.add(way, strengths_of(runs));
        const double mean = levels.mean_at(way);
        progress.note("σt", label_of(point), fmt::format("σt {:.4g} MPa ± {:.2g} %, {} discs", mean * 1e-6, 100 * half, n));
        if (const auto slope = levels.slope(); slope && slope->value > 0) {
            // The same discs at other levels: their own slope, not farther from the first than by a factor of two.
            path.slope = std::clamp(slope->value, 0.5 * path.slope, 2 * path.slope);
        }
        const double next = std::clamp(levels.crossing(target, path.slope), path.low, path.high);
        const bool met = std::abs(std::log(mean / target)) <= near;
        const bool at_end = next == path.low || next == path.high;
        if (!met && next == way && at_end) {
            progress.decision.point = point;
            throw Ended{Ending::not_reached,
                        fmt::format("σt {:.4g} MPa is out of reach at this cc and φc: with {} it is {:.4g} MPa, {:+.1f} % off",
                                    target * 1e-6, label_of(point), mean * 1e-6, 100 * (mean / target - 1))};
        }
        if (!met && !at_end && levels.has(next)) {
            way = levels.nearest(target);
            progress.note("σt", "not nearer", "levels scatter more than they differ");
            break;
        }
        way = next;
        if (met) break;
    }
    progress.decision.point = path.point(progress.rock(), base, way);
    const double width = half / path.slope;
    for (const auto& member : path.members) {
        const double value = *progress.decision.point[member.parameter];
        const double part = std::abs(member.rate) * width;
        std::erase_if(progress.decision.values, [&](const Calibrated& c) { return c.parameter == member.parameter; });
        progress.decision.values.push_back({member.parameter, {value, value * std::exp(-part), value * std::exp(part)}});
    }
}

}  // namespace graincrack::calibrate
