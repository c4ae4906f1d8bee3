#include "solver/run/energy_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

constexpr double unstable_residual = 1.0;  // error over the largest stored energy: no run that means anything
constexpr double least_stress = 0.01;      // of tc: below the energy of this stress the error is noise of the start

double energy_at(double stress, const Specimen& specimen, const Rock& rock) {
    const double area = std::accumulate(specimen.grain_area.begin(), specimen.grain_area.end(), 0.0);
    return 0.5 * stress * stress / rock.young_modulus * area;
}

}  // namespace

EnergyCheck::EnergyCheck(const Specimen& specimen, const SimulationRequest& r)
    : is_dynamic_(!r.why_dynamic().empty()),
      least_energy_(energy_at(least_stress * r.contact.tensile_strength, specimen, r.material.rock)),
      time_step_fraction_(r.time_step_fraction),
      damping_(r.damping) {}

void EnergyCheck::add(const Energies& energies, std::int64_t step) {
    // A dynamic run may be all motion, and store next to nothing.
    scale_ = std::max(scale_, energies.stored() - origin_.stored + (is_dynamic_ ? energies.kinetic : 0));
    worked_ = std::max(worked_, std::abs(energies.external - origin_.external));
    const double error = energies.balance_error() - origin_.error;
    // While next to nothing is stored, an error is small or large against what the platens have worked.
    const double evaluated = std::max(scale_, worked_);
    const double residual = evaluated > 0 ? error / evaluated : 0;
    if (!std::isfinite(residual) || (scale_ > least_energy_ && std::abs(residual) > unstable_residual)) {
        throw_unstable(residual, step);
    }
    largest_error_ = std::max(largest_error_, std::abs(error));
}

void EnergyCheck::check_end(std::int64_t step) const {
    if (const double evaluated = std::max(scale_, worked_); largest_error_ > unstable_residual * evaluated) {
        throw_unstable(largest_error_ / evaluated, step);
    }
}

void EnergyCheck::restore(double scale, double largest_error) {
    scale_ = scale;
    largest_error_ = largest_error;
}

void EnergyCheck::resume(const std::vector<double>& external_work) {
    for (const double work : external_work) worked_ = std::max(worked_, std::abs(work - origin_.external));
}

void EnergyCheck::restart(const EnergyOrigin& origin) {
    origin_ = origin;
    scale_ = worked_ = largest_error_ = 0;
}

void EnergyCheck::throw_unstable(double residual, std::int64_t step) const {
    throw NumericalError(
        fmt::format("the run became unstable before step {} (error of the energy balance {:.0f} %); use a smaller "
                    "--time-step-fraction than {} (with this damping below {:.2f}) or a slower --rate",
                    step, 100 * std::abs(residual), time_step_fraction_, 1 / std::sqrt(1 + damping_)));
}

}  // namespace graincrack
