// A loading program on a small specimen, without a run file.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "solver/loading/stage_control.hpp"
#include "solver/program/program_file.hpp"
#include "solver/run/probes.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {

class ProgramRun {
public:
    ProgramRun(Specimen specimen, const std::string& text, const ContactLaw& law, PlaneCondition plane = PlaneCondition::strain,
               double damping = 0, double fraction = 0.5, const Rock& rock = augig_granite().rock,
               const ContactParameters& contact = augig_contact(), double platen_friction = 0,
               const std::vector<Phase>& phases = {})
        : program(parse_program(text, "test.toml")),
          run(phases.empty() ? SmallRun(std::move(specimen), law, plane, fraction, rock)
                             : SmallRun(std::move(specimen), phases, same_of_every_class(law, phases.size()), plane, fraction)),
          probes(program, run.assemblage, run.specimen),
          stage_controller(program, run.specimen, rock) {
        run.set_boundary(make_program_boundary(run.assemblage, run.specimen, program, contact, platen_friction), fraction);
        run.parameters.damping = damping;
        set_initial_velocities(program, run.assemblage, run.specimen, run.state);
        if (program.has_temperature()) take_temperature(run.assemblage, run.state);
    }
    /// Runs to the end of the program. \param steps time steps between two rows of the history
    void go(std::int64_t steps, int threads = 1) {
        run.begin();
        record();
        const Rows rows{history, [this](const std::string& probe, std::size_t column) { return probes.last(probe, column); }};
        stage_controller.begin(feedback());
        stage_controller.start_next(rows);
        run.state.loading.amplitudes = stage_controller.values(0);
        while (!stage_controller.finished()) {
            const double duration = static_cast<double>(steps) * run.parameters.time_step;
            run.steps(steps, stage_controller.next(duration), threads);
            record();
            stage_controller.check_stage_end(feedback(), rows);
            stage_controller.start_next(rows);
        }
    }
    /// Takes more steps than its program has, with amplitudes of nothing.
    void go_on(std::int64_t steps) {
        const std::vector<Amplitude> nothing(2, Amplitude{{}, 0, true});
        run.steps(steps, {{}, {}, &nothing});
    }
    [[nodiscard]] const std::vector<double>& column(const std::string& probe, const std::string& name) const {
        for (const ProbeHistory& each : probes.histories()) {
            for (std::size_t c = 0; c < each.columns.size(); ++c) {
                if (each.name == probe && each.columns[c].name == name) return each.values[c];
            }
        }
        throw std::out_of_range(probe + "." + name);
    }
    [[nodiscard]] const std::vector<double>& operator[](HistoryColumn c) const { return history[c]; }
    /// max |external − sum| over the largest of all energies
    [[nodiscard]] double residual() const {
        double worst = 0;
        double scale = 0;
        for (const Energies& e : energies) {
            worst = std::max(worst, std::abs(e.balance_error()));
            scale = std::max({scale, e.stored(), e.kinetic});
        }
        return worst / scale;
    }

    Program program;
    SmallRun run;
    Probes probes;
    StageController stage_controller;
    History history;
    std::vector<Energies> energies;

private:
    [[nodiscard]] Feedback feedback() const {
        return {.time = run.state.time,
                .axial_compression = -history[HistoryColumn::axial_stress].back(),
                .unbalanced_ratio = history[HistoryColumn::unbalanced_ratio].back()};
    }
    void record() {
        const Measurement m = run.measured();
        energies.push_back(m.energies);
        for (auto& column : history.columns) column.push_back(0);
        const auto set = [this](HistoryColumn c, double value) { history[c].back() = value; };
        set(HistoryColumn::time, run.state.time);
        set(HistoryColumn::axial_stress, 0.5 * (m.force_top - m.force_bottom) / run.specimen.width);
        const auto& platens = run.state.loading.platen_displacement;
        set(HistoryColumn::axial_strain, (platens[top_platen] - platens[bottom_platen]) / run.specimen.height);
        set(HistoryColumn::unbalanced_ratio, m.unbalanced_ratio);
        set(HistoryColumn::confining_pressure, m.confining_force / run.specimen.height);
        set(HistoryColumn::temperature, run.state.loading.temperature);
        set(HistoryColumn::tensile_cracks, 0.5 * static_cast<double>(run.failed_points()));
        probes.record(run.assemblage, run.boundary, run.state);
    }
};

}  // namespace graincrack::test
