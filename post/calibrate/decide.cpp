#include "post/calibrate/decide.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack::calibrate {

namespace {

constexpr const char* grain_modulus = "rock.young_modulus";
constexpr const char* grain_ratio = "rock.poisson_ratio";

/// Thrown where runs are missing: no later decision can be taken. Caught in `decide` only.
struct RunsMissing {};
/// Thrown where a calibration ends. Caught in `decide` only.
struct Ended {
    Ending ending;
    std::string reason;
    std::string next;
};

/// Tests of each purpose have specimens of their own: tens of thousands by the test, then these.
namespace seeds {
constexpr std::int64_t of_test = 10000;
constexpr std::int64_t elastic = 1;
constexpr std::int64_t design = 1000;  ///< of each design
constexpr std::int64_t point = 10;     ///< of each of its points
constexpr std::int64_t confirmation = 9000;
constexpr std::int64_t again = 50;  ///< of each confirmation, by their number
}  // namespace seeds

/// Values of a target in the runs that have it.
std::vector<double> values_of(const Target& target, const std::vector<const Measures*>& runs) {
    std::vector<double> values;
    for (const Measures* run : runs) {
        const double value = target.read(*run);
        if (std::isfinite(value)) values.push_back(value);
    }
    return values;
}

/// The prediction of the surfaces for a target that was not met.
struct Misfit {
    bool expected = false;      ///< it is off at the optimum of the surfaces too
    bool out_of_reach = false;  ///< no design point of the boxes has it
    std::string remedy;         ///< which parameter would have to go where
};

/// The one of some responses or outcomes that is of a target; null: there is none.
template <class Ones>
auto* find_of(Ones& all, const Target& target) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.target.name() == target.name(); });
    return found == all.end() ? nullptr : &*found;
}

/// Adds to a list in a sentence.
void add(std::string& list, const std::string& item) { list += (list.empty() ? "" : "; ") + item; }

class Calibration {
public:
    Calibration(const Problem& problem, const FindRun& find) : problem_(problem), find_(find) {}
    void run();
    [[nodiscard]] const std::string& first_point() const { return first_point_; }
    Decision decision;

private:
    [[nodiscard]] const Study& study() const { return problem_.study; }
    [[nodiscard]] const Target* target(const char* name) const;
    /// The number of specimens of a test at each point of a design.
    [[nodiscard]] std::size_t specimens_at_point(const Test& test) const {
        return test.loading() == Loading::splitting ? study().discs : 1;
    }
    void record(std::string stage, std::string what, std::string result) {
        decision.steps.push_back({std::move(stage), std::move(what), std::move(result)});
    }
    /// The finished runs of `n` specimens. Missing runs are requested and left out.
    std::vector<const Measures*> get(RequestedRun run, std::size_t n);
    void require_all() const {
        if (!decision.requested.empty()) throw RunsMissing{};
    }
    [[nodiscard]] static Point with_grains(Point point, double modulus, double ratio);

    void find_elasticity();
    void add_value(std::size_t r, const std::vector<const Measures*>& runs);
    void make_design(const Box& box);
    [[nodiscard]] std::string text_of_first_point() const;
    void fit(const Box& box);
    [[nodiscard]] bool meets_targets() const;
    void find_design_point();
    void correct_elasticity();
    [[nodiscard]] std::size_t specimens_for(const Test& test, std::size_t most) const;
    [[nodiscard]] Outcome outcome_of(const Target& target, const std::vector<const Measures*>& runs) const;
    [[nodiscard]] RequestedRun run_at_optimum(std::size_t t, std::string reason) const;
    std::string confirm();
    void add_confirmation();
    void predict();
    [[nodiscard]] Misfit misfit_of(const Outcome& outcome) const;
    void end();

    const Problem& problem_;
    const FindRun& find_;
    std::vector<Test> tests_;      ///< of the designs
    std::vector<Test> confirmed_;  ///< of all targets
    double grain_modulus_ = 0;
    double grain_ratio_ = 0;
    std::size_t designs_ = 0;
    std::size_t confirmations_ = 0;
    std::string first_point_;  ///< its strengths while the other points of the first design are missing
    Box all_;                  ///< holds the boxes of all designs
    Fit fit_;
    std::vector<std::vector<std::optional<bool>>> peaks_;  ///< of each response, whether a test has it; empty: there is none
    std::vector<std::pair<Test, std::vector<const Measures*>>> confirmed_runs_;  ///< of the last confirmation
};

const Target* Calibration::target(const char* name) const {
    const auto found = std::find_if(problem_.targets.begin(), problem_.targets.end(),
                                    [&](const Target& t) { return t.property.name == name && t.use == Use::fit; });
    return found == problem_.targets.end() ? nullptr : &*found;
}

std::vector<const Measures*> Calibration::get(RequestedRun run, std::size_t n) {
    std::vector<const Measures*> runs;
    for (std::size_t i = 0; i < n; ++i, ++run.seed) {
        if (const Measures* found = find_(run)) {
            runs.push_back(found);
        } else {
            decision.requested.push_back(run);
        }
    }
    return runs;
}

Point Calibration::with_grains(Point point, double modulus, double ratio) {
    point.insert(point.begin(), {{grain_modulus, modulus}, {grain_ratio, ratio}});
    return point;
}

/// E within 1 %, ν within 0.0075: half of the usual bounds. Contacts take some per cent of the stiffness, so that to scale by
/// what is off converges by a factor of ten or more a time.
void Calibration::find_elasticity() {
    grain_modulus_ = problem_.young_modulus;
    grain_ratio_ = problem_.poisson_ratio;
    const Target* e = target("young_modulus");
    const Target* nu = target("poisson_ratio");
    if (e == nullptr && nu == nullptr) return;
    const Target* ucs = target("uniaxial");
    // Contacts soften from the start, so that the chord must end where the rock's does, at half its UCS: the strain limit is that
    // of an elastic specimen at its UCS.
    const std::optional<double> limit =
        ucs != nullptr ? std::optional(rounded(ucs->value * (1 - grain_ratio_ * grain_ratio_) / grain_modulus_, 5))
                       : std::nullopt;
    constexpr int attempts = 6;
    const Point contacts = point_at(problem_.parameters, first_guess(problem_.parameters));
    for (int attempt = 0; attempt < attempts; ++attempt) {
        RequestedRun run;
        run.test = Test{std::string(name_of(TestKind::uniaxial)), 0, 0.1};
        run.seed = seeds::elastic;
        run.point = with_grains(contacts, grain_modulus_, grain_ratio_);
        run.max_strain = limit;
        run.label = fmt::format("e{}", attempt + 1);
        run.reason = "E and ν of assemblages of such grains";
        const auto runs = get(run, study().elastic);
        require_all();
        const auto mean = [&](const Target* t, double otherwise) {
            if (t == nullptr) return otherwise;
            const std::vector<double> values = values_of(*t, runs);
            if (!values.empty()) return sample(values).mean.value;
            throw InputError(fmt::format("calibrate: uniaxial runs have no {}; the table of `moduli` must have a row for each",
                                         t->property.name));
        };
        const double requested_e = e != nullptr ? e->value : grain_modulus_;
        const double requested_nu = nu != nullptr ? nu->value : grain_ratio_;
        const double measured_e = mean(e, requested_e);
        const double measured_nu = mean(nu, requested_nu);
        const std::string grains = fmt::format("grains E {:.5g} GPa, ν {:.4g}", grain_modulus_ * 1e-9, grain_ratio_);
        const std::string assemblage = fmt::format("assemblage E {:.5g} GPa, ν {:.4g}", measured_e * 1e-9, measured_nu);
        record("elasticity", grains, assemblage);
        if (std::abs(measured_e / requested_e - 1) <= 0.01 && std::abs(measured_nu - requested_nu) <= 0.0075) return;
        grain_modulus_ *= requested_e / measured_e;
        grain_ratio_ += requested_nu - measured_nu;
        const bool outside = grain_modulus_ > 2 * problem_.young_modulus || grain_modulus_ < 0.5 * problem_.young_modulus ||
                             !(grain_ratio_ >= 0.01 && grain_ratio_ <= 0.45);
        if (outside || attempt + 1 == attempts) {
            throw Ended{
                Ending::not_reached,
                fmt::format("E {:.4g} GPa and ν {:.3g} are out of reach: {} make an {}", requested_e * 1e-9, requested_nu, grains,
                            assemblage),
                "give contacts that are stiffer than the process zone's (contact.normal_stiffness, contact.shear_stiffness)"};
        }
    }
}

/// Adds what the specimens of a point have of a response.
void Calibration::add_value(std::size_t r, const std::vector<const Measures*>& runs) {
    Response& response = fit_.responses[r];
    const std::vector<double> values = values_of(response.target, runs);
    response.values.push_back(values.empty() ? NAN : response.target.logarithm(sample(values).mean.value));
    response.tests += runs.size();
    response.measured += values.size();
    peaks_[r].push_back(!values.empty());
}

/// Adds the points of one more design: a specimen of each test at each design point, three discs. The first point is made before
/// the others, so that a rock that is far from its laboratory values shows early.
void Calibration::make_design(const Box& box) {
    const auto p = static_cast<std::size_t>(box.size());
    const std::size_t n = study().points > 0 ? study().points : 4 * (p + 2);
    const std::vector<DesignPoint> points = sobol_points(box, designs_ * n, n);
    ++designs_;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t t = 0; t < tests_.size(); ++t) {
            RequestedRun run;
            run.test = tests_[t];
            run.seed = static_cast<std::int64_t>(t + 1) * seeds::of_test + static_cast<std::int64_t>(designs_) * seeds::design +
                       static_cast<std::int64_t>(i) * seeds::point;
            run.point = with_grains(point_at(problem_.parameters, points[i]), grain_modulus_, grain_ratio_);
            run.label = fmt::format("d{}p{:02}", designs_, i + 1);
            run.reason = fmt::format("design {}, point {} of {}", designs_, i + 1, n);
            const auto runs = get(run, specimens_at_point(run.test));
            for (std::size_t r = 0; r < fit_.responses.size(); ++r) {
                if (run.test.has(fit_.responses[r].target)) add_value(r, runs);
            }
        }
        if (i > 0 || designs_ > 1) continue;
        require_all();
        first_point_ = text_of_first_point();
    }
    fit_.points.insert(fit_.points.end(), points.begin(), points.end());
    require_all();
    first_point_.clear();
}

/// The fitted targets at the first point: "; the middle of the ranges has UCS 134 MPa (target 285 MPa), no first peak at 8 MPa".
std::string Calibration::text_of_first_point() const {
    std::vector<std::string> values;
    for (const Response& response : fit_.responses) {
        const Target& t = response.target;
        if (t.use != Use::fit || t.is_elastic()) continue;
        const double found = t.of_logarithm(response.values.front());
        values.push_back(std::isnan(found)
                             ? "no " + t.symbol()
                             : fmt::format("{} {} (target {})", t.symbol(), t.text(rounded(found, 3)), t.text(t.value)));
    }
    return fmt::format("; the middle of the ranges has {}", fmt::join(values, ", "));
}

/// Surfaces through the points inside a box, and the design point where they meet the targets best.
void Calibration::fit(const Box& box) {
    fit_.box = box;
    std::vector<DesignPoint> points;
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < fit_.points.size(); ++i) {
        if (!box.contains(fit_.points[i])) continue;
        points.push_back(fit_.points[i]);
        inside.push_back(i);
    }
    std::vector<Residual> residuals;
    std::vector<Logistic> logistics;
    for (Response& response : fit_.responses) {
        std::vector<double> values;
        for (const std::size_t i : inside) values.push_back(response.values[i]);
        response.surface = LocalSurface::fit(box, points, values);
    }
    for (std::size_t r = 0; r < fit_.responses.size(); ++r) {
        const Response& response = fit_.responses[r];
        if (response.target.use != Use::fit || response.target.is_elastic()) continue;
        if (response.surface) {
            const Target& t = response.target;
            residuals.push_back({&*response.surface, t.logarithm(t.value), t.log_deviation()});
        }
        if (!response.target.property.needs_first_peak || response.measured == response.tests) continue;
        std::vector<std::size_t> tested;
        std::copy_if(inside.begin(), inside.end(), std::back_inserter(tested),
                     [&](std::size_t i) { return peaks_[r][i].has_value(); });
        Eigen::MatrixXd factors(static_cast<Eigen::Index>(tested.size()), box.size());
        Eigen::VectorXd happened(factors.rows());
        for (std::size_t i = 0; i < tested.size(); ++i) {
            factors.row(static_cast<Eigen::Index>(i)) = fit_.points[tested[i]].transpose();
            happened(static_cast<Eigen::Index>(i)) = *peaks_[r][tested[i]] ? 1 : 0;
        }
        logistics.push_back(fit_logistic(factors, happened));
    }
    std::vector<ProbabilityConstraint> constraints;
    for (const Logistic& logistic : logistics) constraints.push_back({&logistic, study().first_peak_fraction});
    if (residuals.empty()) {
        throw Ended{Ending::undecided, fmt::format("no target can be fitted from {} points", inside.size()),
                    "ask for more points (setting points=N), or for targets that these tests have"};
    }
    fit_.optimum = find_optimum(box, first_guess(problem_.parameters), residuals, constraints);
    decision.point = with_grains(point_at(problem_.parameters, fit_.optimum.point), grain_modulus_, grain_ratio_);
    decision.fit = fit_;
    record("fit", fmt::format("{} points of {} designs in the box", inside.size(), designs_),
           label_of(point_at(problem_.parameters, fit_.optimum.point)));
}

/// True if the surfaces expect every target at the optimum, each within a quarter of its deviation.
bool Calibration::meets_targets() const {
    return std::all_of(fit_.responses.begin(), fit_.responses.end(), [&](const Response& response) {
        if (response.target.use != Use::fit || response.target.is_elastic() || !response.surface) return true;
        const double off = response.surface->value(fit_.optimum.point) - response.target.logarithm(response.target.value);
        return std::abs(off) <= 0.25 * response.target.log_deviation();
    });
}

/// Designs until the optimum is inside the last box and new specimens are within every bound there. Where they are not, they join
/// the points of the design, and others are asked at the new optimum; then follows a smaller design about it.
void Calibration::find_design_point() {
    const auto p = static_cast<Eigen::Index>(problem_.parameters.size());
    const Box limits = limits_of(problem_.parameters);
    Box box{DesignPoint::Zero(p), DesignPoint::Ones(p)};
    all_ = box;
    std::size_t moves = 0;
    std::size_t zooms = 0;
    bool corrected = false;  // since the last design
    const auto begin_design = [&](const Box& in) {
        box = in;
        all_ = hull(all_, box);
        make_design(box);
        corrected = false;
    };
    begin_design(box);
    while (true) {
        fit(box);
        const DesignPoint at = fit_.optimum.point;
        const Box moved = box.about(at, 1, limits);
        // At an edge: so near that the box would move by nearly half of its width. Directions that are unidentified do not move
        // it, nor does an edge at which every target is met.
        std::string moving;
        const bool is_met = meets_targets();
        for (Eigen::Index k = 0; k < p; ++k) {
            const bool at_edge =
                std::abs(box.local(at)(k)) > 0.98 && std::abs(moved.centre(k) - box.centre(k)) > 0.1 * box.half(k);
            if (at_edge && !is_met && fit_.optimum.unidentified_fraction(k) < 0.5) {
                moving += (moving.empty() ? "" : ", ") + problem_.parameters[static_cast<std::size_t>(k)].key;
            }
        }
        if (!moving.empty() && moves < study().moves) {
            ++moves;
            record("move", "the optimum is at an edge of the box: " + moving, "the box moves there");
            begin_design(moved);
            continue;
        }
        if (!moving.empty()) record("edge", "the optimum is still at an edge of the box: " + moving, "no more moves");
        correct_elasticity();
        const std::string missed = confirm();
        if (missed.empty()) return;
        const std::string reason = "new specimens are not within every bound: " + missed;
        if (!corrected) {
            corrected = true;
            add_confirmation();
            record("correction", reason, "they join the points of the design");
        } else if (zooms < study().zooms) {
            ++zooms;
            record("zoom", reason, "a box of half the width about the optimum");
            begin_design(box.about(at, 0.5, limits));
        } else {
            return;
        }
    }
}

/// E and ν change a little with the contacts: the grains of the confirmation are scaled once more, by the surfaces.
void Calibration::correct_elasticity() {
    const DesignPoint at = fit_.optimum.point;
    double modulus = grain_modulus_;
    double ratio = grain_ratio_;
    for (const Response& response : fit_.responses) {
        if (response.target.use != Use::fit || !response.surface) continue;
        const double expected = std::exp(response.surface->value(at));
        if (response.target.property.name == "young_modulus") modulus *= response.target.value / expected;
        if (response.target.property.name == "poisson_ratio") {
            ratio = std::clamp(ratio + response.target.value - expected, 0.01, 0.45);
        }
    }
    decision.point = with_grains(point_at(problem_.parameters, at), modulus, ratio);
}

/// Within: of a fitted target the mean is within the bound and its standard error no larger, of a predicted one the whole 95 %
/// interval is within; outside: the whole interval is beyond the bound.
std::string verdict_on(const Target& target, const Sample& ours) {
    const double off = std::abs(ours.mean.value - target.value);
    const double half = ours.mean.high ? *ours.mean.high - ours.mean.value : std::numeric_limits<double>::infinity();
    const double error = ours.deviation ? *ours.deviation / std::sqrt(static_cast<double>(ours.n)) : 0;
    const bool within =
        target.use == Use::fit ? off <= target.deviation && error <= target.deviation : off + half <= target.deviation;
    if (within) return "within";
    return off - half > target.deviation ? "outside" : "undecided";
}

/// Specimens of which, by the scatter about the surfaces, half of the 95 % interval of the mean is below the deviation of every
/// target of a test, three at least; the most where a target has no surface.
std::size_t Calibration::specimens_for(const Test& test, std::size_t most) const {
    std::size_t n = std::min<std::size_t>(3, most);
    for (const Response& response : fit_.responses) {
        const Target& target = response.target;
        if (target.use != Use::fit || !test.has(target)) continue;
        if (!response.surface) return most;
        const double scatter = response.surface->scatter() * std::sqrt(static_cast<double>(specimens_at_point(test)));
        const auto half = [&] { return student_t_95(static_cast<int>(n) - 1) * scatter / std::sqrt(static_cast<double>(n)); };
        while (n < most && !(n > 1 && half() <= target.log_deviation())) ++n;
    }
    return n;
}

Outcome Calibration::outcome_of(const Target& target, const std::vector<const Measures*>& runs) const {
    const std::vector<double> values = values_of(target, runs);
    Outcome outcome{target, {}, runs.size(), ""};
    if (!values.empty()) outcome.ours = sample(values);
    const auto share = static_cast<double>(values.size()) / static_cast<double>(runs.size());
    if (std::isfinite(target.value)) {
        const bool lacking = target.property.needs_first_peak && share < study().first_peak_fraction;
        // A fitted one is asked of the specimen that it is tested on.
        const std::string caveat = target.use == Use::fit ? "" : target.caveat(study().specimens.bend());
        outcome.verdict = !caveat.empty() ? caveat : !outcome.ours || lacking ? "outside" : verdict_on(target, *outcome.ours);
    }
    return outcome;
}

/// New specimens of a test at the optimum.
RequestedRun Calibration::run_at_optimum(std::size_t t, std::string reason) const {
    RequestedRun run;
    run.test = confirmed_[t];
    run.seed = static_cast<std::int64_t>(t + 1) * seeds::of_test + seeds::confirmation +
               static_cast<std::int64_t>(confirmations_) * seeds::again;
    run.point = decision.point;
    run.label = fmt::format("c{}", confirmations_);
    run.reason = std::move(reason);
    return run;
}

/// The optimum on new specimens: as many as the scatter of the designs asks for, and where these do not show every target
/// within its bound, as many as the study has at most.
/// \return what is not within its bound; empty: nothing
std::string Calibration::confirm() {
    ++confirmations_;
    decision.outcomes.clear();
    confirmed_runs_.clear();
    for (std::size_t t = 0; t < confirmed_.size(); ++t) {
        std::vector<const Target*> fitted;
        for (const Target& target : problem_.targets) {
            if (target.use == Use::fit && confirmed_[t].has(target)) fitted.push_back(&target);
        }
        if (fitted.empty()) continue;
        const std::size_t most =
            confirmed_[t].loading() == Loading::splitting ? study().confirmation_discs : study().confirmation_rectangles;
        const RequestedRun run = run_at_optimum(t, "the optimum on new specimens");
        const std::size_t n = specimens_for(confirmed_[t], most);
        std::vector<const Measures*> found = get(run, n);
        if (found.size() < n) continue;
        const bool enough = n == most || std::all_of(fitted.begin(), fitted.end(), [&](const Target* target) {
                                return outcome_of(*target, found).verdict == "within";
                            });
        if (!enough) found = get(run, most);
        confirmed_runs_.emplace_back(confirmed_[t], std::move(found));
    }
    require_all();
    std::string missed;
    for (const auto& [test, found] : confirmed_runs_) {
        for (const Target& target : problem_.targets) {
            if (!test.has(target)) continue;
            decision.outcomes.push_back(outcome_of(target, found));
            if (target.use == Use::fit && decision.outcomes.back().verdict != "within") add(missed, target.symbol());
        }
    }
    return missed;
}

/// The specimens of the last confirmation become points at the optimum, of as many specimens as a point has. E and ν are left
/// out, for the grains were scaled.
void Calibration::add_confirmation() {
    std::size_t n_points = 0;
    for (const auto& [test, runs] : confirmed_runs_) n_points = std::max(n_points, runs.size() / specimens_at_point(test));
    fit_.points.insert(fit_.points.end(), n_points, DesignPoint(fit_.optimum.point));
    for (std::size_t r = 0; r < fit_.responses.size(); ++r) {
        Response& response = fit_.responses[r];
        for (const auto& [test, runs] : confirmed_runs_) {
            if (!test.has(response.target) || response.target.is_elastic()) continue;
            const auto n = static_cast<std::ptrdiff_t>(specimens_at_point(test));
            for (auto run = runs.begin(); runs.end() - run >= n; run += n) add_value(r, {run, run + n});
        }
        response.values.resize(fit_.points.size(), NAN);
        peaks_[r].resize(fit_.points.size());
    }
}

/// Tests of predictions alone, and the outcomes in the order of the targets.
void Calibration::predict() {
    const std::vector<Outcome> outcomes = std::exchange(decision.outcomes, {});
    std::map<std::size_t, std::vector<const Measures*>> runs;  // by the test
    for (const Target& target : problem_.targets) {
        if (const Outcome* known = find_of(outcomes, target)) {
            decision.outcomes.push_back(*known);
            continue;
        }
        const auto t = std::find_if(confirmed_.begin(), confirmed_.end(), [&](const Test& test) { return test.has(target); });
        const auto test = static_cast<std::size_t>(t - confirmed_.begin());
        if (!runs.contains(test)) runs[test] = get(run_at_optimum(test, "a prediction"), study().predicted);
        decision.outcomes.push_back(outcome_of(target, runs[test]));
    }
    require_all();
    // Repeated tests say how equal points scatter.
    for (Response& response : fit_.responses) {
        const Outcome* const outcome = find_of(decision.outcomes, response.target);
        if (outcome == nullptr || !outcome->ours || !outcome->ours->deviation || outcome->ours->n < 3) continue;
        const auto n = static_cast<double>(specimens_at_point({response.target.test()}));
        response.pure_error = response.target.log_deviation(outcome->ours->mean.value, *outcome->ours->deviation) / std::sqrt(n);
        response.pure_freedom = static_cast<int>(outcome->ours->n) - 1;
    }
    decision.fit = fit_;
}

/// "UCS +12 % off (± 3 %)": SI values as parts of the target
std::string off_text(const Outcome& o) {
    const Target& t = o.target;
    if (!o.ours) return fmt::format("{}: none of {} tests has a value", t.symbol(), o.tests);
    const double scale = t.property.absolute ? 1 : 100 / t.value;
    const char* unit = t.property.absolute ? "" : " %";
    const double half = o.ours->mean.high ? *o.ours->mean.high - o.ours->mean.value : NAN;
    std::string text = fmt::format("{} differs by {:+.3g}{} (± {:.2g}{}, bound {:.2g}{})", t.symbol(),
                                   (o.ours->mean.value - t.value) * scale, unit, half * scale, unit, t.deviation * scale, unit);
    if (o.ours->n < o.tests) text += fmt::format(", {} of {} tests have a value", o.ours->n, o.tests);
    return text;
}

Misfit Calibration::misfit_of(const Outcome& outcome) const {
    const Target& t = outcome.target;
    const Response* const response = find_of(fit_.responses, t);
    if (response == nullptr || t.is_elastic()) return {};
    if (!response->surface) {
        return {true, true,
                fmt::format("{} of {} tests of the designs have a value of {}", response->measured, response->tests, t.symbol())};
    }
    const DesignPoint& point = fit_.optimum.point;
    const double requested = t.logarithm(t.value);
    const double here = response->surface->value(point);
    const double allowed = 0.5 * t.log_deviation() + 2 * std::sqrt(response->surface->variance(point));
    const bool lacking = outcome.ours && outcome.ours->n < outcome.tests && outcome.verdict == "outside";
    if (std::abs(here - requested) <= allowed && !lacking) return {};
    // This target alone may be in reach or not, by a surface through the points of all designs.
    const auto wide = LocalSurface::fit(all_, fit_.points, response->values);
    double lowest = here;
    double highest = here;
    for (const DesignPoint& at : sobol_points(all_, 0, 1024)) {
        const double spread = 2 * std::sqrt(wide->variance(at));
        lowest = std::min(lowest, wide->value(at) - spread);
        highest = std::max(highest, wide->value(at) + spread);
    }
    // The parameter that moves it most, and where it would have to go alone.
    const DesignPoint gradient = response->surface->gradient(point);
    Eigen::Index k = 0;
    gradient.cwiseAbs().maxCoeff(&k);
    const Parameter& p = problem_.parameters[static_cast<std::size_t>(k)];
    const double to = point(k) + (requested - here) / gradient(k);
    return {true, requested < lowest || requested > highest,
            fmt::format("{} alone would need {} to change from {} to {} (first box {} to {})", t.symbol(), p.key,
                        value_text(p.key, p.value(point(k)), " "),
                        std::abs(to) < 10 ? value_text(p.key, p.value(to), " ") : "far outside", value_text(p.key, p.low, " "),
                        value_text(p.key, p.high, " "))};
}

void Calibration::end() {
    std::string missed;
    std::string remedies;
    std::string specimens;
    bool expected = false;
    bool out_of_reach = false;
    bool outside = false;
    for (const Outcome& o : decision.outcomes) {
        if (o.target.use == Use::predict || o.verdict == "within") continue;
        add(missed, off_text(o) + ": " + o.verdict);
        const Misfit misfit = misfit_of(o);
        if (misfit.expected) add(remedies, misfit.remedy);
        expected = expected || misfit.expected;
        out_of_reach = out_of_reach || misfit.out_of_reach;
        outside = outside || o.verdict == "outside";
        if (o.ours && o.ours->deviation) {
            const double n =
                std::max(std::pow(2 * *o.ours->deviation / o.target.deviation, 2), 2.0 * static_cast<double>(o.tests));
            add(specimens, fmt::format("{:.0f} for {}", std::ceil(n), o.target.symbol()));
        }
    }
    if (missed.empty()) {
        throw Ended{Ending::calibrated, "new specimens are within the bounds of every target",
                    "use calibrated.toml like any other material; predicted values were not fitted"};
    }
    remedies += "; free another parameter ([parameters]), or give a target a larger deviation";
    if (expected && out_of_reach) throw Ended{Ending::not_reached, missed, remedies};
    if (expected) {
        throw Ended{Ending::contradictory, missed, "each target can be reached, but not all of them together: " + remedies};
    }
    const std::string another = fmt::format("ask for one more design (setting zooms={})", study().zooms + 1);
    if (outside) {
        throw Ended{Ending::undecided, missed, "the response surfaces predict that every target is met here: " + another};
    }
    throw Ended{Ending::undecided, missed,
                fmt::format("confirm on more specimens, about {} (settings confirmation_discs=N, confirmation_rectangles=N), or "
                            "{}; settings are given by --set, or by SET= of make",
                            specimens, another)};
}

void Calibration::run() {
    // Fitted targets come first, then other targets and everything else that the same tests measure.
    std::vector<Target> fitted;
    for (const Target& t : problem_.targets) {
        if (t.use == Use::fit) fitted.push_back(t);
    }
    tests_ = tests_of(fitted);
    confirmed_ = tests_of(problem_.targets);
    const auto add_response = [&](const Target& t) {
        for (const Response& known : fit_.responses) {
            if (known.target.name() == t.name() ||
                (known.target.test() == t.test() && known.target.property.column == t.property.column &&
                 known.target.confining_pressure == t.confining_pressure)) {
                return;
            }
        }
        fit_.responses.push_back({t, {}, {}, {}});
    };
    for (const Target& t : fitted) add_response(t);
    for (const Test& test : tests_) {
        for (const Target& t : problem_.targets) {
            if (test.has(t) && t.property.peak_drop <= test.peak_drop) add_response(t);
        }
        for (const Property& property : all_properties()) {
            if (property.pressure == PressureOf::name && !(test.confining_pressure > 0)) continue;
            if (property.pressure == PressureOf::none && test.confining_pressure > 0) continue;
            const Target t{property, test.confining_pressure, NAN, NAN, Use::predict};
            if (test.has(t) && property.peak_drop <= test.peak_drop) add_response(t);
        }
    }
    peaks_.resize(fit_.responses.size());
    find_elasticity();
    find_design_point();
    predict();
    end();
}

}  // namespace

std::string label_of(Ending ending) {
    return name_in({"runs are needed", "calibrated", "not reached", "contradictory", "undecided"}, ending);
}

Decision decide(const Problem& problem, const FindRun& find) {
    Calibration calibration(problem, find);
    Decision& decision = calibration.decision;
    try {
        calibration.run();
    } catch (const RunsMissing&) {
        decision.reason = decision.requested.front().reason + calibration.first_point();
    } catch (const Ended& end) {
        decision.ending = end.ending;
        decision.reason = end.reason;
        decision.next = end.next;
    }
    return std::move(decision);
}

}  // namespace graincrack::calibrate
