// Controls heating within the stages of a program: the temperature changes at the automatic rate, and later stages do not count
// the stored energy and the cracks that heat leaves in a specimen.
#pragma once

#include "share/file/peak.hpp"
#include "share/file/specimen.hpp"
#include "solver/loading/platen_control.hpp"
#include "solver/loading/rate_control.hpp"
#include "solver/loading/stage_ends.hpp"
#include "solver/model/amplitude.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

class ThermalStage {
public:
    /// \param difference of the free expansions of the minerals (`expansion_difference`), 1/K; 0 where nothing expands
    ThermalStage(const Program& program, const Specimen& specimen, const Rock& rock, double difference);

    /// True if the specimen has, or had, a temperature. The rest of the class applies to such specimens only.
    [[nodiscard]] bool is_thermal() const { return is_thermal_; }
    void set_thermal() { is_thermal_ = true; }

    /// Begins a stage. \param amplitude of the temperature; null if there is none
    void begin(const Stage& stage, const Amplitude* amplitude, const Feedback& feedback, const History& history);
    /// Continues after another program. \param locked_in energy that no longer counts, J; null if no platens have moved in it
    void take_over(const double* locked_in) {
        is_thermal_ = true;
        has_moved_ = locked_in != nullptr;
        if (has_moved_) locked_in_ = *locked_in;
    }
    /// Restores the control of a stage that resumes.
    void resume(const Stage& stage) {
        if (stage.heating) control_ = control_of(*stage.heating);
        await_fall(stage);
    }
    /// True while the temperature changes at the automatic rate and has not reached its end.
    [[nodiscard]] bool heats() const { return heats_; }
    /// Sets the temperature of the next `duration` seconds. \return false once it has reached its end
    bool heat(const Feedback& feedback, double duration, Amplitude& temperature);

    /// The unbalanced ratio; for a specimen with a temperature, with element forces of at least `HeatingScales::least_force`.
    [[nodiscard]] double unbalanced_ratio(const Feedback& feedback) const {
        return is_thermal_ ? scales_.loaded(feedback) : feedback.unbalanced_ratio;
    }
    /// Number of contacts that failed before the stage.
    [[nodiscard]] double cracks_before() const { return cracks_before_; }
    /// Measures that control the platens: relative to a load, and none after a peak.
    [[nodiscard]] Feedback of_load(Feedback feedback, const PlatenControl& platens);
    /// Estimates the time of a change of the temperature (K) while minerals crack, s.
    [[nodiscard]] double usual_time(const AutomaticHeating& heating, double change) const {
        return control_of(heating).usual_time(change);
    }

    /// Calls `visit(name, member)` with every member that changes.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("heats", self.heats_);
        visit("heating_from", self.from_);
        visit("platens_moved", self.has_moved_);
        visit("locked_in", self.locked_in_);
        visit("cracks_before", self.cracks_before_);
        visit("highest_load", self.highest_);
        HeatingControl::visit_state(self.control_, visit);
    }

private:
    /// A heated peak is passed once the stress has fallen by the drop that ends the stage, and by `heated_fall` at least.
    void await_fall(const Stage& stage) { fallen_ = stage.peak_drop ? std::min(1 - *stage.peak_drop, 1 - heated_fall) : 0; }
    [[nodiscard]] HeatingControl control_of(const AutomaticHeating& heating) const {
        return {heating.tolerance, scales_, heating.share};
    }
    bool is_thermal_;
    HeatingScales scales_;
    HeatingControl control_;  ///< sets the rate of the temperature
    bool heats_ = false;
    double from_ = 0;           ///< temperature at the begin of the stage, K
    bool has_moved_ = false;    ///< true if the platens have moved in this stage or an earlier one
    double locked_in_ = 0;      ///< stored energy when they first moved, J
    double cracks_before_ = 0;  ///< number of contacts
    double highest_ = 0;        ///< highest axial stress of the stage, Pa
    double fallen_ = 0;         ///< fraction of it below which a peak is passed
};

}  // namespace graincrack
