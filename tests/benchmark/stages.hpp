// The stages of a step on a specimen under load, for benchmarks: what each does, and the least it could take.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/model/vertex_clusters.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/stable_time_step.hpp"
#include "solver/step/step.hpp"
#include "tests/support/augig_granite.hpp"

namespace graincrack::benchmark {

/// Augig granite between platens, intact and compressed to about a tenth of its strength.
struct LoadedSpecimen {
    Specimen specimen;
    Assemblage assemblage;
    StepParameters parameters;
    Boundary boundary;
    State state;

    LoadedSpecimen(Specimen s, LawVariant law, bool scaled, VectorTarget vector_target);
    /// Further steps at the platens' speed.
    void advance_by(std::int64_t steps, ThreadTeam& team);
    [[nodiscard]] double grains() const { return static_cast<double>(specimen.n_grains()); }
};

/// A part of a step.
struct Stage {
    std::string name;
    double operations;             ///< additions, multiplications, divisions, roots of a grain-step, counted in the source
    double bytes;                  ///< read and written of a grain-step, each array once
    void (*run)(LoadedSpecimen&);  ///< once over all blocks
};

/// The stages of a step of this specimen, in their order.
std::vector<Stage> stages_of(const LoadedSpecimen& loaded);

}  // namespace graincrack::benchmark
