#include "solver/detection/copy_check.hpp"

#include <fmt/format.h>

#include <bit>
#include <map>
#include <string_view>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

/// A hash of numbers in their order (FNV-1a over their bits).
class Hash {
public:
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(std::uint64_t bits) { value_ = (value_ ^ bits) * 1099511628211ULL; }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 14695981039346656037ULL;
};

struct Copy {
    std::int64_t chunk;
    std::uint64_t hash;
};

Copy copy_of_contacts(const Assemblage& a, std::int32_t chunk, const State& s) {
    Hash hash;
    const Range contacts = a.contact_chunks[chunk].contacts;
    for (std::int32_t c = contacts.begin; c < contacts.end; ++c) {
        for (const std::size_t point : points_of(c)) {
            for (const auto* values : {&s.opening, &s.sliding, &s.integrity, &s.slip, &s.fracture_energy}) {
                hash.add((*values)[point]);
            }
            hash.add(std::uint64_t{s.failed[point]} + 2U * s.residual[point]);
        }
        for (std::int32_t k = 0; k < 4; ++k) {
            hash.add(s.contact_force[slot_of(c, k)]);
            hash.add(s.contact_force[slot_of(c, k) + contacts_per_chunk]);
        }
    }
    return {chunk, hash.value()};
}

/// Of the pairs of a node. What is left of a contact that has ended, its owner alone has, and nobody reads.
Copy copy_of_pairs(Range group, const ContactPairList& list) {
    Hash hash;
    for (std::int32_t i = group.begin; i < group.end; ++i) {
        const NodeEdgeContact& contact = list.contacts[i];
        hash.add(static_cast<std::uint64_t>(list.pairs[i].edge));
        const bool exists = contact.active || contact.release_correction != 0;
        hash.add(std::uint64_t{contact.active ? 1U : 0U} + (exists && contact.near_first ? 2U : 0U));
        for (const double value :
             {contact.area, contact.initial_overlap, contact.overlap, contact.elastic_slip, contact.release_correction}) {
            hash.add(exists ? value : 0);
        }
    }
    return {list.pairs[group.begin].node, hash.value()};
}

void compare(const Ranks& ranks, const std::vector<Copy>& own, std::string_view kind, std::int64_t step) {
    std::map<std::int64_t, std::pair<std::uint64_t, std::size_t>> first;  // hash and rank
    const std::vector<std::vector<Copy>> of_ranks = ranks.gather_all(own);
    for (std::size_t rank = 0; rank < of_ranks.size(); ++rank) {
        for (const auto& [chunk, hash] : of_ranks[rank]) {
            const auto [at, is_new] = first.try_emplace(chunk, hash, rank);
            if (!is_new && at->second.first != hash) {
                throw NumericalError(fmt::format("step {}: ranks {} and {} differ in {} {}; this is a fault of graincrack-solve",
                                                 step, at->second.second, rank, kind, chunk));
            }
        }
    }
}

}  // namespace

void require_equal_copies(const Assemblage& a, const State& s) {
    if (a.part.is_alone()) return;
    std::vector<Copy> contacts;
    for (const std::int32_t chunk : a.part.evaluated_contacts.outer) contacts.push_back(copy_of_contacts(a, chunk, s));
    compare(*a.part.ranks, contacts, "the chunk of contacts", s.step);
    std::vector<Copy> pairs;
    for (const Range group : s.contact_pairs.groups) pairs.push_back(copy_of_pairs(group, s.contact_pairs));
    compare(*a.part.ranks, pairs, "the pairs of node", s.step);
}

}  // namespace graincrack
