// Checks by the energy balance that a run is stable.
#pragma once

#include <cstdint>
#include <vector>

#include "share/file/specimen.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// The origin of energies, J.
struct EnergyOrigin {
    double stored = 0, error = 0, external = 0;
};

class EnergyCheck {
public:
    EnergyCheck(const Specimen& specimen, const SimulationRequest& request);
    /// Takes the energies of a row. \throws NumericalError if the run has become unstable
    void add(const Energies& energies, std::int64_t step);
    /// \throws NumericalError if the run was unstable before it had enough energy for the check
    void check_end(std::int64_t step) const;
    /// Continues the check of another run. \param scale and \param largest_error as below
    void restore(double scale, double largest_error);
    /// Continues the same run. \param external_work in all its rows, J
    void resume(const std::vector<double>& external_work);
    /// Counts from these energies of the last row on, as energy that heat stored before a test would hide the errors of the test.
    void restart(const EnergyOrigin& origin);
    /// Counts from the origin of another run or a checkpoint.
    void count_from(const EnergyOrigin& origin) { origin_ = origin; }

    [[nodiscard]] double scale() const { return scale_; }                  ///< largest stored energy so far, J
    [[nodiscard]] double largest_error() const { return largest_error_; }  ///< largest error of the balance so far, J
    /// An error over the largest stored energy.
    [[nodiscard]] double relative(double error) const { return scale_ > 0 ? error / scale_ : 0; }
    /// The error of the last row over the largest stored energy.
    [[nodiscard]] double relative_error(const Energies& energies) const {
        return relative(energies.balance_error() - origin_.error);
    }

private:
    [[noreturn]] void throw_unstable(double residual, std::int64_t step) const;

    bool is_dynamic_;
    double least_energy_;  ///< with less energy the error is noise of the start, J
    double time_step_fraction_, damping_;
    double scale_ = 0;
    double worked_ = 0;  ///< largest external work so far, absolute, J
    double largest_error_ = 0;
    EnergyOrigin origin_;
};

}  // namespace graincrack
