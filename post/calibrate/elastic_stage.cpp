#include "post/calibrate/elastic_stage.hpp"

#include <fmt/format.h>

#include <cmath>

#include "post/calibrate/elasticity.hpp"
#include "share/error.hpp"
#include "share/units.hpp"

namespace graincrack::calibrate {

namespace {

/// E within 1 %, ν within 0.0075: half of the bounds of the confirmation.
bool near(const Elasticity& measured, const Elasticity& wanted) {
    return std::abs(measured.young_modulus / wanted.young_modulus - 1) <= 0.01 &&
           std::abs(measured.poisson_ratio - wanted.poisson_ratio) <= 0.0075;
}

std::string label_of(const Elasticity& e) {
    return fmt::format("E {:.5g} GPa, ν {:.4g}", e.young_modulus * 1e-9, e.poisson_ratio);
}

/// Means over assemblages. \throws InputError if a run has no moduli
std::pair<Elasticity, Elasticity> measured_and_predicted(const std::vector<FinishedRun>& runs) {
    Elasticity measured;
    Elasticity predicted;
    const double share = 1 / static_cast<double>(runs.size());
    for (const FinishedRun& run : runs) {
        if (!run.young_modulus || !run.poisson_ratio || !run.predicted_young_modulus || !run.predicted_poisson_ratio) {
            throw InputError(
                fmt::format("calibrate: the uniaxial run of seed {} has no moduli; the table of `moduli` must have a row "
                            "for each uniaxial run",
                            run.seed));
        }
        measured.young_modulus += share * *run.young_modulus;
        measured.poisson_ratio += share * *run.poisson_ratio;
        predicted.young_modulus += share * *run.predicted_young_modulus;
        predicted.poisson_ratio += share * *run.predicted_poisson_ratio;
    }
    return {measured, predicted};
}

}  // namespace

void find_elasticity(Progress& progress) {
    const Material& rock = progress.rock();
    const Elasticity wanted{progress.laboratory("young_modulus"), progress.laboratory("poisson_ratio")};
    Point& point = progress.decision.point;
    // Later stages change cc and φc; E and ν hardly follow. Contacts soften from the start, so that the chord must end where the
    // rock's does, at half its UCS: the strain limit is that of an elastic specimen at its UCS.
    point = point.with(Parameter::young_modulus, wanted.young_modulus).with(Parameter::poisson_ratio, wanted.poisson_ratio);
    const double limit =
        progress.laboratory("compressive_strength") * (1 - wanted.poisson_ratio * wanted.poisson_ratio) / wanted.young_modulus;
    const double edge = progress.study().specimens.mean_edge();
    Point base = point;
    for (const Parameter p : {Parameter::tensile_strength, Parameter::cohesion, Parameter::friction_angle}) {
        base = base.with(p, first_guess(p, rock, base, edge));
        progress.note("first guess", label_of(p, *base[p]), std::string(row_of(p).symbol) + ": " + row_of(p).first_guess);
    }
    for (int attempt = 0; attempt < 4; ++attempt) {
        WantedRun run{"uniaxial", 0, 0, base, graincrack::rounded(limit, 5), "E and ν of assemblages of such grains"};
        run.point[Parameter::young_modulus] = point[Parameter::young_modulus];
        run.point[Parameter::poisson_ratio] = point[Parameter::poisson_ratio];
        const auto [measured, predicted] = measured_and_predicted(progress.get(run, seeds::near, progress.study().elastic));
        const Elasticity grains{*point[Parameter::young_modulus], *point[Parameter::poisson_ratio]};
        progress.note("elasticity", "grains " + label_of(grains), "assemblage " + label_of(measured));
        if (near(measured, wanted)) break;
        const Elasticity next = grains_for(material_at(rock, run.point), measured, predicted, wanted);
        const Range e = range_of(Parameter::young_modulus, rock, point, 0);
        const Range nu = range_of(Parameter::poisson_ratio, rock, point, 0);
        const bool outside = !(next.young_modulus >= e.low && next.young_modulus <= e.high && next.poisson_ratio >= nu.low &&
                               next.poisson_ratio <= nu.high);
        if (attempt == 3 || outside) {
            throw Ended{Ending::not_reached,
                        fmt::format("{} is out of reach: grains with {} give {}; contacts stiffer than the process zone's "
                                    "(contact.normal_stiffness, contact.shear_stiffness) would be needed",
                                    label_of(wanted), label_of(grains), label_of(measured))};
        }
        point = point.with(Parameter::young_modulus, next.young_modulus).with(Parameter::poisson_ratio, next.poisson_ratio);
    }
    point[Parameter::cohesion] = base[Parameter::cohesion];
    point[Parameter::friction_angle] = base[Parameter::friction_angle];
    point[Parameter::tensile_strength] = base[Parameter::tensile_strength];
}

}  // namespace graincrack::calibrate
