// Ghost nodes: nodes of other ranks that a rank reads. Their owners send displacements and velocities to the readers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "solver/ranks/ranks.hpp"

namespace graincrack {

class GhostNodes {
public:
    /// Number of values of a node in the message of a step: displacement (m) and velocity (m/s).
    static constexpr std::size_t n_motion = 4;

    /// Asks the owners for nodes. \param ghosts nodes that this rank reads, ascending \param owner_of (node) → its rank
    template <class OwnerOf>
    GhostNodes(const Ranks& ranks, const std::vector<std::int32_t>& ghosts, const OwnerOf& owner_of) : n_ghosts_(ghosts.size()) {
        std::vector<std::vector<std::int32_t>> requested(static_cast<std::size_t>(ranks.size()));
        for (const std::int32_t node : ghosts) requested[static_cast<std::size_t>(owner_of(node))].push_back(node);
        const std::vector<std::vector<std::int32_t>> asked = ranks.exchange(requested);
        std::vector<ChannelEnd> motion;
        std::vector<ChannelEnd> number;
        for (int rank = 0; rank < ranks.size(); ++rank) {
            const auto& out = asked[static_cast<std::size_t>(rank)];
            const auto& in = requested[static_cast<std::size_t>(rank)];
            if (out.empty() && in.empty()) continue;
            neighbours_.push_back({rank, out, in});
            motion.push_back({rank, n_motion * out.size(), n_motion * in.size()});
            number.push_back({rank, out.size(), in.size()});
        }
        motion_ = ranks.open(motion);
        number_ = ranks.open(number);
    }

    /// Sends the values of a step. \param get (node) → its `n_motion` values
    template <class Get>
    void start(const Get& get) const {
        for (std::size_t i = 0; i < neighbours_.size(); ++i) {
            double* to = motion_->to_send(i).data();
            for (const std::int32_t node : neighbours_[i].sent) {
                const std::array<double, n_motion> numbers = get(node);
                for (const double number : numbers) *to++ = number;
            }
        }
        motion_->start();
    }
    /// Waits for the values from other ranks. \param set (node, pointer to its `n_motion` values)
    template <class Set>
    void finish(const Set& set) const {
        motion_->finish();
        for (std::size_t i = 0; i < neighbours_.size(); ++i) {
            const double* from = motion_->received(i).data();
            for (const std::int32_t node : neighbours_[i].received) {
                set(node, from);
                from += n_motion;
            }
        }
    }
    /// Sends one value of each ghost from its owner. \param get (node) → value \param set (node, value)
    template <class Get, class Set>
    void update(const Get& get, const Set& set) const {
        for (std::size_t i = 0; i < neighbours_.size(); ++i) {
            double* to = number_->to_send(i).data();
            for (const std::int32_t node : neighbours_[i].sent) *to++ = get(node);
        }
        number_->start();
        number_->finish();
        for (std::size_t i = 0; i < neighbours_.size(); ++i) {
            const double* from = number_->received(i).data();
            for (const std::int32_t node : neighbours_[i].received) set(node, *from++);
        }
    }
    [[nodiscard]] std::size_t n_neighbours() const { return neighbours_.size(); }
    [[nodiscard]] std::size_t n_ghosts() const { return n_ghosts_; }

private:
    struct Neighbour {
        int rank;
        std::vector<std::int32_t> sent, received;  ///< nodes, ascending
    };
    std::size_t n_ghosts_;
    std::vector<Neighbour> neighbours_;
    std::unique_ptr<Channel> motion_, number_;
};

}  // namespace graincrack
