// The check that the energy balance of a run is that of a stable one.
#pragma once

#include <cstdint>
#include <vector>

#include "share/file/specimen.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// What energies count from, J.
struct EnergyOrigin {
    double stored = 0, error = 0, external = 0;
};

class EnergyCheck {
public:
    EnergyCheck(const Specimen& specimen, const SimulationRequest& request);
    /// Takes the energies of a row. \throws NumericalError if the run has become unstable
    void add(const Energies& energies, std::int64_t step);
    /// \throws NumericalError if it was unstable before there was enough energy to tell
    void check_end(std::int64_t step) const;
    /// Continues what another run had. \param scale and \param largest_error as below
    void restore(double scale, double largest_error);
    /// Also the external work in all its rows, J.
    void resume(const std::vector<double>& external_work);
    /// Counts from these energies on, those of the last row: what heat has stored before a test hides the test's errors.
    void restart(const EnergyOrigin& origin);
    /// Counts from what another run, or a checkpoint, counted from.
    void count_from(const EnergyOrigin& origin) { origin_ = origin; }

    [[nodiscard]] double scale() const { return scale_; }                  ///< largest stored energy so far, J
    [[nodiscard]] double largest_error() const { return largest_error_; }  ///< of the balance so far, J
    /// An error over the largest stored energy.
    [[nodiscard]] double relative(double error) const { return scale_ > 0 ? error / scale_ : 0; }
    /// The error of the last row over the largest stored energy.
    [[nodiscard]] double relative_error(const Energies& energies) const {
        return relative(energies.balance_error() - origin_.error);
    }

private:
    [[noreturn]] void throw_unstable(double residual, std::int64_t step) const;

    bool is_dynamic_;
    double least_energy_;  ///< below it the error is noise of the start, J
    double time_step_fraction_, damping_;
    double scale_ = 0;
    double worked_ = 0;  ///< largest external work so far, absolute, J
    double largest_error_ = 0;
    EnergyOrigin origin_;
};

}  // namespace graincrack
