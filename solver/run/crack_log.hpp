// The log of micro-cracks, collected from the events of the contact stage.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "share/file/run_file.hpp"
#include "solver/model/state.hpp"

namespace graincrack {

class CrackLog {
public:
    explicit CrackLog(std::size_t n_points) : crack_of_point_(n_points, -1) {}
    /// Takes the events of all chunks, ordered by step, contact of the specimen and point, and clears them. The first rank has
    /// the rows of all ranks, other ranks their numbers.
    void collect(const Assemblage& assemblage, double time_step, State& state);
    /// Continues the rows of an earlier run.
    void restore(const std::vector<Crack>& rows);
    /// The rows, with the energy that each point has released so far. \param fracture_energy of all ranks, as in `State`
    [[nodiscard]] std::vector<Crack> rows(const Assemblage& assemblage, const std::vector<double>& fracture_energy) const;
    /// The number of micro-cracks by an event up to a time (s), on the first rank.
    [[nodiscard]] ModeCounts counts(CrackEvent event, double time = std::numeric_limits<double>::infinity()) const {
        return count_modes(cracks_, {event}, time);
    }
    [[nodiscard]] std::size_t tensile_points() const { return tensile_; }
    [[nodiscard]] std::size_t shear_points() const { return count_ - tensile_; }
    [[nodiscard]] bool empty() const { return count_ == 0; }

private:
    std::vector<Crack> cracks_;
    std::vector<std::int32_t> crack_of_point_;  ///< row of a point of a contact of the specimen, −1 for none
    std::size_t count_ = 0, tensile_ = 0;
};

}  // namespace graincrack
