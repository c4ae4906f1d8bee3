#include "post/calibrate/decide.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack::calibrate {

namespace {

constexpr const char* grain_modulus = "rock.young_modulus";
constexpr const char* grain_ratio = "rock.poisson_ratio";
/// Prior standard deviation of a coordinate, which is half of the width of the first boxes. It describes the rocks of a type. An
/// unusual rock, which misses targets with it, has twice as much, and four times if many specimens still miss one.
constexpr double usual_prior = 1;
/// Smallest decrease of the sum of squared residuals that is worth further specimens: half a standard deviation of one target.
constexpr double pointless = 0.25;

/// Thrown if runs are missing, so that no later decision can be taken. Only `decide` catches it.
struct RunsMissing {};

/// Seeds of specimens. Each purpose has seeds of its own: the test gives the tens of thousands, and these numbers the rest.
namespace seeds {
constexpr std::int64_t of_test = 10000;
constexpr std::int64_t elastic = 1;
constexpr std::int64_t design = 1000;  ///< of each design
constexpr std::int64_t point = 10;     ///< of each of its points
constexpr std::int64_t confirmation = 9000;
constexpr std::int64_t again = 50;  ///< of each confirmation, by their number
}  // namespace seeds

class Calibration {
public:
    Calibration(const Problem& problem, const FindRun& find)
        : problem_(problem), find_(find), kind_(problem.kind, problem.rock, problem.parameters, problem.study) {}
    void run();
    [[nodiscard]] const std::string& first_guess() const { return first_guess_; }
    Decision decision;

private:
    [[nodiscard]] const Study& study() const { return problem_.study; }
    [[nodiscard]] const Target* target(const char* name) const;
    [[nodiscard]] DesignPoint first() const { return calibrate::first_guess(problem_.parameters); }
    void record(std::string stage, std::string what, std::string result) {
        decision.steps.push_back({std::move(stage), std::move(what), std::move(result)});
    }
    /// The finished runs of `n` specimens. Missing runs are requested and left out.
    std::vector<const Measures*> get(RequestedRun run, std::size_t n);
    void require_all() const {
        if (!decision.requested.empty()) throw RunsMissing{};
    }
    [[nodiscard]] static Point with_grains(Point point, double modulus, double ratio);

    void find_elasticity(const Point& contacts);
    [[nodiscard]] std::string expected_text() const;
    void begin_with_kind();
    void begin_design(const Box& box);
    void make_design(const Box& box);
    void optimise();
    [[nodiscard]] bool meets_targets(double deviations) const;
    bool leave_edge();
    void find_design_point();
    bool correct(const DesignPoint& at);
    void correct_elasticity();
    [[nodiscard]] RequestedRun run_at_optimum(std::size_t t, std::string reason) const;
    std::string confirm(bool until_decided);
    void learn(const std::vector<const Measures*>& runs, const Test& test);
    void predict();

    const Problem& problem_;
    const FindRun& find_;
    KindPrior kind_;
    std::vector<Test> tests_;      ///< tests of the designs
    std::vector<Test> confirmed_;  ///< tests of all targets
    double grain_modulus_ = 0;
    double grain_ratio_ = 0;
    std::size_t designs_ = 0;
    std::size_t moves_ = 0;
    std::size_t corrections_ = 0;  ///< since the last design
    std::size_t confirmations_ = 0;
    std::string first_guess_;  ///< strengths of the first guess, in words, while no others are known
    double widest_prior_ = 2;
    Box all_;  ///< the hull of the boxes of all designs
    Fit fit_;
    std::vector<std::pair<Test, std::vector<const Measures*>>> confirmed_runs_;  ///< of the last confirmation
};

const Target* Calibration::target(const char* name) const {
    const auto found =
        std::ranges::find_if(problem_.targets, [&](const Target& t) { return t.property.name == name && t.use == Use::fit; });
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

/// Finds E within 1 % and ν within 0.0075, which is half of the usual bounds. Contacts lower the stiffness by some per cent, so
/// that scaling by the ratio of target and result reduces the error by a factor of ten or more each time.
void Calibration::find_elasticity(const Point& contacts) {
    const Target* e = target("young_modulus");
    const Target* nu = target("poisson_ratio");
    if (e == nullptr && nu == nullptr) return;
    const Target* ucs = target("uniaxial");
    // Contacts soften from the start, so that the chord must end at half the UCS, as for the rock. An elastic specimen at its UCS
    // gives the strain limit.
    const std::optional<double> limit =
        ucs != nullptr ? std::optional(rounded(ucs->value * (1 - grain_ratio_ * grain_ratio_) / grain_modulus_, 5))
                       : std::nullopt;
    constexpr int attempts = 6;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        const auto runs = get({.test = {std::string(name_of(TestKind::uniaxial)), 0, 0.1},
                               .seed = seeds::elastic,
                               .point = with_grains(contacts, grain_modulus_, grain_ratio_),
                               .max_strain = limit,
                               .label = fmt::format("e{}", attempt + 1),
                               .reason = "E and ν of assemblages of such grains"},
                              study().elastic);
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

/// Adds the points of one more design, with one specimen of each test at each design point but three discs. The first point runs
/// before the others, so that a rock far from its laboratory values is noticed early.
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
            const auto runs = get(run, study().specimens_at_point(run.test));
            for (Response& response : fit_.responses) {
                if (run.test.has(response.target)) add_value(response, runs);
            }
        }
        if (i > 0 || designs_ > 1) continue;
        require_all();
        first_guess_ = expected_text();
    }
    fit_.points.insert(fit_.points.end(), points.begin(), points.end());
    for (Response& response : fit_.responses) response.values.resize(fit_.points.size(), NAN);  // responses of the rock type only
    require_all();
    first_guess_.clear();
}

/// The fitted targets at the start of the search, in words: "; the middle of the ranges has UCS 134 MPa (target 285 MPa), no
/// first peak at 8 MPa", or the predictions of the rock type.
std::string Calibration::expected_text() const {
    std::vector<std::string> values;
    const bool has_design = designs_ > 0;
    for (const Response& response : fit_.responses) {
        const Target& t = response.target;
        if (t.use != Use::fit || t.is_elastic() || !(has_design || response.surface)) continue;
        const double found = t.of_logarithm(has_design ? response.values.front() : response.surface->value(fit_.optimum.point));
        values.push_back(std::isnan(found)
                             ? "no " + t.symbol()
                             : fmt::format("{} {} (target {})", t.symbol(), t.text(rounded(found, 3)), t.text(t.value)));
    }
    if (values.empty()) return "";
    const std::string who = has_design ? "the middle of the ranges has" : "the kind " + problem_.kind->kind() + " expects";
    return fmt::format("; {} {}", who, fmt::join(values, ", "));
}

/// Takes all response surfaces of the rock type. The optimum at which they meet the targets is the first guess.
void Calibration::begin_with_kind() {
    fit_.box = all_ = kind_.box();
    for (Response& response : fit_.responses) response.surface = kind_.surface(response.target);
    optimise();
    first_guess_ = expected_text();
    record("kind", "surfaces of the kind " + problem_.kind->kind(), label_of(point_at(problem_.parameters, fit_.optimum.point)));
}

/// Makes one more design, and fits surfaces to all points that lie in its box.
void Calibration::begin_design(const Box& box) {
    fit_.box = box;
    corrections_ = 0;
    all_ = designs_ == 0 ? box : hull(all_, box);
    make_design(box);
    const std::size_t inside = fit_surfaces(fit_);
    record("fit", fmt::format("{} points of {} designs in the box", inside, designs_), "surfaces");
}

/// Finds the design point at which the surfaces meet the targets best.
void Calibration::optimise() {
    std::vector<ProbabilityConstraint> constraints;
    for (const Logistic& share : fit_.shares) constraints.push_back({&share, study().first_peak_fraction});
    const std::vector<Residual> residuals = residuals_of(fit_.responses);
    if (residuals.empty()) {
        throw Ended{Ending::undecided, fmt::format("no target can be fitted from {} points", fit_.points.size()),
                    "ask for more points (setting points=N), or for targets that these tests have"};
    }
    const auto find = [&](double prior) { fit_.optimum = find_optimum(fit_.box, first(), residuals, constraints, prior); };
    for (double prior = usual_prior; prior <= widest_prior_; prior *= 2) {
        find(prior);
        if (meets_targets(0.5)) break;
    }
    decision.point = with_grains(point_at(problem_.parameters, fit_.optimum.point), grain_modulus_, grain_ratio_);
    decision.fit = fit_;
}

/// True if the surfaces predict every target at the optimum within this multiple of its deviation.
bool Calibration::meets_targets(double deviations) const {
    const std::vector<double>& off = fit_.optimum.deviations;
    return std::ranges::all_of(off, [&](double deviation) { return std::abs(deviation) <= deviations; });
}

/// Makes another design if the optimum lies at an edge of the last box, which then moves, or of the rock type's design before any
/// specimen exists, and a target is missed there. \return false if it makes none
bool Calibration::leave_edge() {
    if (meets_targets(designs_ > 0 ? 0.25 : 1)) return false;
    const DesignPoint at = fit_.optimum.point;
    const Box limits = limits_of(problem_.parameters);
    if (designs_ == 0) {
        if (confirmations_ > 0 || !kind_.ends_at(at)) return false;
        record("edge", "a target is missed where the kind " + problem_.kind->kind() + " ends", "a design of its own");
        begin_design(Box{at, DesignPoint::Ones(at.size())}.about(at, 1, limits));
        return true;
    }
    const Box moved = fit_.box.about(at, 1, limits);
    std::string moving;
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        // At an edge the box would move by nearly half of its width. Undetermined coordinates move no box.
        const bool at_edge =
            std::abs(fit_.box.local(at)(k)) > 0.98 && std::abs(moved.centre(k) - fit_.box.centre(k)) > 0.1 * fit_.box.half(k);
        if (at_edge && !fit_.optimum.is_undetermined(k)) {
            moving += (moving.empty() ? "" : ", ") + problem_.parameters[static_cast<std::size_t>(k)].key;
        }
    }
    if (moving.empty()) return false;
    const bool moves = moves_++ < study().moves;
    record(moves ? "move" : "edge", "the optimum is at an edge of the box: " + moving,
           moves ? "the box moves there" : "no more moves");
    if (moves) begin_design(moved);
    return moves;
}

/// Searches, from the surfaces of the rock type or else of a design, for a point at which new specimens are within every bound.
/// Specimens beyond a bound correct the surfaces; others follow at the new optimum while its misfit is smaller, then a smaller
/// design.
void Calibration::find_design_point() {
    const std::string lacking = kind_.lacks(problem_.targets);
    if (lacking.empty()) {
        begin_with_kind();
    } else {
        record("kind", lacking, "a design of its own");
    }
    find_elasticity(point_at(problem_.parameters, lacking.empty() ? fit_.optimum.point : first()));
    if (!lacking.empty()) begin_design({DesignPoint::Zero(first().size()), DesignPoint::Ones(first().size())});
    std::size_t zooms = 0;
    optimise();
    while (true) {
        while (leave_edge()) optimise();
        correct_elasticity();
        const Point point = decision.point;
        const Fit before = fit_;
        std::string missed = confirm(false);
        bool is_corrected = !missed.empty() && correct(before.optimum.point);
        if (!missed.empty() && !is_corrected && designs_ == 0) {
            // The verdict needs as many specimens as are allowed.
            fit_ = before;
            decision.point = point;
            --confirmations_;
            missed = confirm(true);
            widest_prior_ = 4;
            is_corrected = !missed.empty() && correct(before.optimum.point);
        }
        const std::string reason = "new specimens are not within every bound: " + missed;
        if (is_corrected) {
            record("correction", reason, "they correct the surfaces");
        } else if (!missed.empty() && designs_ > 0 && zooms < study().zooms) {
            ++zooms;
            record("zoom", reason, "a box of half the width about the optimum");
            begin_design(fit_.box.about(before.optimum.point, 0.5, limits_of(problem_.parameters)));
            optimise();
        } else {
            fit_.optimum = before.optimum;
            update(fit_.optimum, residuals_of(fit_.responses));
            decision.point = point;
            return;
        }
    }
}

/// Finds the optimum of surfaces that new specimens have corrected. \param at the point of these specimens \return false if the
/// number of corrections is reached, or if no other point promises a smaller misfit
bool Calibration::correct(const DesignPoint& at) {
    optimise();
    const std::vector<Residual> residuals = residuals_of(fit_.responses);
    const double gained = misfit(at, residuals) - misfit(fit_.optimum.point, residuals);
    const bool is_elastic = std::ranges::any_of(
        decision.outcomes, [](const Outcome& o) { return o.target.is_elastic() && o.target.use == Use::fit && !o.is_met(); });
    if (corrections_ >= (designs_ > 0 ? 1 : study().corrections) || !(gained > pointless || is_elastic)) return false;
    ++corrections_;
    return true;
}

/// Scales the grains of a confirmation once more, as E and ν change a little with the contacts, by the surfaces or else by the
/// specimens of the confirmation before.
void Calibration::correct_elasticity() {
    const auto expected = [&](const char* name) {
        const Target* const t = target(name);
        if (t == nullptr) return std::optional<double>();
        const Response* const response = find_of(fit_.responses, *t);
        if (response != nullptr && response->surface) {
            return std::optional(std::exp(response->surface->value(fit_.optimum.point)));
        }
        const Outcome* const before = find_of(decision.outcomes, *t);
        const bool is_off =
            before != nullptr && before->ours && std::abs(before->ours->mean.value - t->value) > 0.5 * t->deviation;
        return is_off ? std::optional(before->ours->mean.value) : std::nullopt;
    };
    double modulus = grain_modulus_;
    double ratio = grain_ratio_;
    if (const auto e = expected("young_modulus")) modulus *= target("young_modulus")->value / *e;
    if (const auto nu = expected("poisson_ratio")) ratio = std::clamp(ratio + target("poisson_ratio")->value - *nu, 0.01, 0.45);
    if (designs_ == 0) std::tie(grain_modulus_, grain_ratio_) = std::pair(modulus, ratio);
    decision.point = with_grains(point_at(problem_.parameters, fit_.optimum.point), modulus, ratio);
}

/// The request for new specimens of a test at the optimum.
RequestedRun Calibration::run_at_optimum(std::size_t t, std::string reason) const {
    return {.test = confirmed_[t],
            .seed = static_cast<std::int64_t>(t + 1) * seeds::of_test + seeds::confirmation +
                    static_cast<std::int64_t>(confirmations_) * seeds::again,
            .point = decision.point,
            .max_strain = {},
            .label = fmt::format("c{}", confirmations_),
            .reason = std::move(reason)};
}

/// Tests the optimum on new specimens, as many as the scatter requires, and more if these do not show every target within its
/// bound. They correct the surfaces.
/// \return the targets that are not within their bounds; "" if there are none
std::string Calibration::confirm(bool until_decided) {
    ++confirmations_;
    std::vector<std::size_t> n(confirmed_.size(), 0);
    for (std::size_t t = 0; t < confirmed_.size(); ++t) {
        const bool is_fitted = std::ranges::any_of(
            problem_.targets, [&](const Target& target) { return target.use == Use::fit && confirmed_[t].has(target); });
        if (is_fitted) n[t] = specimens_for(confirmed_[t], fit_, study());
    }
    for (bool grows = true; grows;) {
        confirmed_runs_.clear();
        for (std::size_t t = 0; t < confirmed_.size(); ++t) {
            if (n[t] > 0) {
                confirmed_runs_.emplace_back(confirmed_[t], get(run_at_optimum(t, "the optimum on new specimens"), n[t]));
            }
        }
        require_all();
        grows = false;
        for (std::size_t t = 0, i = 0; t < confirmed_.size(); ++t) {
            if (n[t] == 0) continue;
            const auto& runs = confirmed_runs_[i++].second;
            const std::size_t more = more_specimens_for(confirmed_[t], runs, problem_.targets, fit_, study(), until_decided);
            grows = grows || more > n[t];
            n[t] = more;
        }
    }
    first_guess_.clear();
    std::string missed;
    decision.outcomes.clear();
    for (const auto& [test, found] : confirmed_runs_) {
        learn(found, test);
        for (const Target& target : problem_.targets) {
            if (!test.has(target)) continue;
            decision.outcomes.push_back(outcome_of(target, found, study()));
            if (target.use == Use::fit && !decision.outcomes.back().is_met()) add(missed, target.symbol());
        }
    }
    return missed;
}

/// Corrects the surfaces by specimens at the optimum. E and ν are left out, because the grains were scaled.
void Calibration::learn(const std::vector<const Measures*>& runs, const Test& test) {
    for (Response& response : fit_.responses) {
        const Target& t = response.target;
        if (!test.has(t) || t.is_elastic() || !response.surface) continue;
        const std::vector<double> values = values_of(t, runs);
        const auto specimens = static_cast<double>(specimens_of(response, study()));
        for (const double value : values) response.surface->learn(fit_.optimum.point, t.logarithm(value), specimens);
        if (!response.surface->is_of_kind()) continue;
        response.tests += runs.size();
        response.measured += values.size();
    }
}

/// Runs the tests that only predictions need, and sorts the outcomes in the order of the targets.
void Calibration::predict() {
    const std::vector<Outcome> outcomes = std::exchange(decision.outcomes, {});
    std::map<std::size_t, std::vector<const Measures*>> runs;  // by the test
    for (const Target& target : problem_.targets) {
        if (const Outcome* known = find_of(outcomes, target)) {
            decision.outcomes.push_back(*known);
            continue;
        }
        const auto t = std::ranges::find_if(confirmed_, [&](const Test& test) { return test.has(target); });
        const auto test = static_cast<std::size_t>(t - confirmed_.begin());
        if (!runs.contains(test)) runs[test] = get(run_at_optimum(test, "a prediction"), study().predicted);
        decision.outcomes.push_back(outcome_of(target, runs[test], study()));
    }
    require_all();
    if (designs_ == 0) {
        for (const auto& [test, found] : runs) learn(found, confirmed_[test]);
    }
    decision.fit = fit_;
}

void Calibration::run() {
    // Fitted targets come first, then other targets and the other properties that the same tests measure.
    std::vector<Target> fitted;
    for (const Target& t : problem_.targets) {
        if (t.use == Use::fit) fitted.push_back(t);
    }
    tests_ = tests_of(fitted);
    confirmed_ = tests_of(problem_.targets);
    const auto add_response = [&](const Target& t) {
        const auto same = [&](const Response& known) {
            return known.target.name() == t.name() ||
                   (known.target.test() == t.test() && known.target.property.column == t.property.column &&
                    known.target.confining_pressure == t.confining_pressure);
        };
        if (std::ranges::none_of(fit_.responses, same)) fit_.responses.push_back({t, {}, {}, {}});
    };
    for (const Target& t : fitted) add_response(t);
    if (kind_.lacks(problem_.targets).empty()) {
        for (const Target& t : problem_.targets) add_response(t);
    }
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
    grain_modulus_ = problem_.young_modulus;
    grain_ratio_ = problem_.poisson_ratio;
    find_design_point();
    predict();
    throw ending_of(decision.outcomes, fit_, all_, problem_.parameters, study());
}

}  // namespace

Decision decide(const Problem& problem, const FindRun& find) {
    Calibration calibration(problem, find);
    Decision& decision = calibration.decision;
    try {
        calibration.run();
    } catch (const RunsMissing&) {
        decision.reason = decision.requested.front().reason + calibration.first_guess();
    } catch (const Ended& end) {
        static_cast<Ended&>(decision) = end;
    }
    return std::move(decision);
}

}  // namespace graincrack::calibrate
