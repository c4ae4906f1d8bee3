#include "solver/restart/state_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "share/base/error.hpp"
#include "solver/detection/pair_list.hpp"
#include "solver/model/contact_pairs.hpp"

namespace graincrack {
namespace {

constexpr double max_travel = 1e3;  // of a node, in sizes of the specimen: beyond any fragment of a test
constexpr double max_speed = 1e5;   // m/s, some twenty times the speed of waves in rock
constexpr double round_off = 1e-9;  // of a time that is a number of steps

class StateCheck {
public:
    StateCheck(const std::string& name, const Setup& setup, const State& s)
        : name_(name), a_(setup.assemblage), setup_(setup), s_(s) {}

    void require(bool holds, const char* what) const {
        if (!holds) {
            throw InputError(
                fmt::format("{}: the state does not fit together: {}; it is damaged, or of another program", name_, what));
        }
    }

    void check_clock(double time_step) const {
        require(s_.step >= 0 && s_.origin_step >= 0 && s_.origin_step <= s_.step, "steps");
        const double time = time_of(s_, s_.step, time_step);
        require(std::abs(time - s_.time) <= round_off * (std::abs(time) + time_step), "time and steps");
        const ContactPairList& list = s_.contact_pairs;
        require(list.detection_interval >= 1 && list.detection_interval <= max_update_interval, "steps between two detections");
        require(list.next_update >= 0 && list.next_update <= s_.step + max_update_interval, "step of the next list update");
    }

    void check_motion() const {
        double size = 0;
        for (const Vector2& p : a_.position) size = std::max({size, std::abs(p.x), std::abs(p.y)});
        const auto all_within = [this](const std::vector<Vector2>& values, double limit, const char* what) {
            require(std::all_of(values.begin(), values.end(), [limit](const Vector2& v) { return dot(v, v) <= limit * limit; }),
                    what);
        };
        all_within(s_.displacement, max_travel * size, "displacements");
        all_within(s_.contact_pairs.displacement_at_search, max_travel * size, "displacements at the last search");
        all_within(s_.damping_load.mean_displacement, max_travel * size, "mean displacements");
        all_within(s_.velocity, max_speed, "velocities");
        for (const double increment : s_.loading.increment_before) {
            require(std::abs(increment) <= max_speed * setup_.parameters.time_step, "speeds of the platens");
        }
        for (const double displacement : s_.loading.platen_displacement) {
            require(std::abs(displacement) <= max_travel * size, "displacements of the platens");
        }
    }

    void check_points() const {
        const auto are_flags = [](const std::vector<std::uint8_t>& flags) {
            return std::all_of(flags.begin(), flags.end(), [](std::uint8_t flag) { return flag <= 1; });
        };
        const auto are_shares = [](const std::vector<double>& values) {
            return std::all_of(values.begin(), values.end(), [](double value) { return value >= 0 && value <= 1; });
        };
        const ContactPairList& list = s_.contact_pairs;
        require(are_flags(s_.failed) && are_flags(s_.residual) && are_flags(list.debonded) && are_flags(list.released),
                "marks of contacts");
        require(are_shares(s_.integrity) && are_shares(s_.next_mark), "integrity of contacts");
        const std::size_t n = s_.clusters.near_platen.size();
        require(n == 0 || n == a_.position.size(), "nodes of vertex clusters");
        require(s_.clusters.sums.size() == (setup_.parameters.mass_scaling.is_on() ? a_.node_chunks.size() : 0),
                "energies of vertex clusters");
        require(
            std::all_of(s_.clusters.near_platen.begin(), s_.clusters.near_platen.end(), [](std::uint8_t p) { return p <= 2; }),
            "platens of vertex clusters");
    }

    void check_pairs() const {
        const ContactPairList& list = s_.contact_pairs;
        const auto n_edges = static_cast<std::int32_t>(a_.surface.edges.size());
        for (std::size_t i = 0; i < list.pairs.size(); ++i) {
            const auto& [node, edge] = list.pairs[i];
            require(node >= 0 && node < a_.n_nodes() && edge >= 0 && edge < n_edges, "nodes and edges of pairs");
            require(i == 0 || list.pairs[i - 1] < list.pairs[i], "order of pairs");
        }
        require(list.contacts.size() == list.pairs.size() && list.forces.size() == 3 * list.pairs.size(), "contacts of pairs");
        for (const NodeEdgeContact& contact : list.contacts) {
            require(contact.area >= 0 && (contact.area > 0 || !contact.active), "areas of node-edge contacts");
        }
        const std::size_t n = list.displacement_at_search.size();
        require(n == a_.position.size() || (n == 0 && list.watched.empty()), "nodes of the pair list");
        require(!list.displacement_at_search.empty() || list.pairs.empty(), "the last search");
    }

    void check_watched() const {
        const ContactPairList& list = s_.contact_pairs;
        for (std::size_t i = 0; i < list.watched.size(); ++i) {
            require(list.watched[i] >= 0 && static_cast<std::size_t>(list.watched[i]) < list.pairs.size(), "watched pairs");
            require(i == 0 || list.watched[i - 1] < list.watched[i], "order of watched pairs");
        }
    }

    void check_active() const {
        const ContactPairList& list = s_.contact_pairs;
        require(list.active.pair.size() == list.watched.size() && list.active.count.size() == list.chunks.size(),
                "active contacts");
        for (std::size_t chunk = 0; chunk < list.chunks.size(); ++chunk) {
            const Range groups = list.chunks[chunk];
            const Range watched{list.watched_groups[groups.begin].begin, list.watched_groups[groups.end - 1].end};
            const std::int32_t count = list.active.count[chunk];
            require(count >= 0 && count <= watched.size(), "numbers of active contacts");
            const auto first = list.active.pair.begin() + watched.begin;
            std::vector<std::int32_t> pairs(first, first + count);
            std::sort(pairs.begin(), pairs.end());
            const bool differ = std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end();
            require(differ && std::includes(list.watched.begin() + watched.begin, list.watched.begin() + watched.end,
                                            pairs.begin(), pairs.end()),
                    "active contacts of chunks");
        }
    }

private:
    const std::string& name_;
    const Assemblage& a_;
    const Setup& setup_;
    const State& s_;
};

}  // namespace

void require_sound_state(const std::string& name, const Setup& setup, double time_step, State& state) {
    const StateCheck check(name, setup, state);
    check.check_clock(time_step);
    check.check_motion();
    check.check_points();
    check.check_pairs();
    check.check_watched();
    group_pairs(state.contact_pairs);
    group_watched(setup.assemblage, state.contact_pairs);
    check.check_active();
}

}  // namespace graincrack
