#include "solver/step/step_shares.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace graincrack {
namespace {

// Instructions of a step. Measured with callgrind on crystals of four minerals with mass scaling (AVX2, g++ 12), intact and after
// the peak under pressure. Other laws and vector units have much the same proportions.
constexpr double of_node = 40, of_cluster = 150, of_platen_point = 120;
constexpr double of_contact_chunk = 1260, of_contact = 160;
constexpr double of_softening = 130;  // additional, of each such point
constexpr double of_residual = 45;    // additional, of each contact in a chunk with such a point
constexpr double of_element = 56, of_loaded_edge = 55;
constexpr double of_active_contact = 210, of_watched_pair = 250;  // the second in a step with detection

/// Divides consecutive items into a range for each thread, so that the largest load is as small as possible.
/// \param cost of an item \param busy [threads] cost of other work of the threads; that of their items is added
template <class CostOf>
std::vector<Range> level(std::size_t n_items, const CostOf& cost, std::vector<double>& busy) {
    if (busy.size() == 1) return {{0, static_cast<std::int32_t>(n_items)}};
    std::vector<double> before{0};  // [items + 1] cumulative cost
    for (std::size_t i = 0; i < n_items; ++i) before.push_back(before.back() + cost(static_cast<std::int32_t>(i)));
    std::vector<Range> ranges(busy.size());
    const auto suffices = [&](double limit) {
        std::int32_t next = 0;
        for (std::size_t t = 0; t < busy.size(); ++t) {
            const double end = before[next] + std::max(limit - busy[t], 0.0);
            const auto beyond = std::upper_bound(before.begin() + next, before.end(), end);
            ranges[t] = {next, static_cast<std::int32_t>(beyond - before.begin()) - 1};
            next = ranges[t].end;
        }
        return next == static_cast<std::int32_t>(n_items);
    };
    double too_low = std::accumulate(busy.begin(), busy.end(), before.back()) / static_cast<double>(busy.size());
    double enough = *std::max_element(busy.begin(), busy.end()) + before.back() + 1;
    for (int i = 0; i < 20; ++i) {
        const double limit = 0.5 * (too_low + enough);
        (suffices(limit) ? enough : too_low) = limit;
    }
    suffices(enough);
    for (std::size_t t = 0; t < busy.size(); ++t) busy[t] += before[ranges[t].end] - before[ranges[t].begin];
    return ranges;
}

double busiest_over_mean(const std::vector<double>& busy) {
    const double sum = std::accumulate(busy.begin(), busy.end(), 0.0);
    return sum > 0 ? *std::max_element(busy.begin(), busy.end()) * static_cast<double>(busy.size()) / sum : 1;
}

double cost_of_contacts(Range contacts, const State* s) {
    double cost = of_contact_chunk + of_contact * contacts.size();
    if (s != nullptr) {
        const auto first = s->residual.begin() + 2 * contacts.begin;
        const auto last = first + 2 * contacts.size();
        cost +=
            of_softening * std::inner_product(first, last, s->failed.begin() + 2 * contacts.begin, 0, std::plus{}, std::less{});
        cost += std::find(first, last, 1) == last ? 0 : of_residual * contacts.size();
    }
    return cost;
}

double cost_of_pairs(const ContactPairList& list, std::int32_t chunk) {
    const std::int32_t watched = list.watched_groups[list.chunks[chunk].end - 1].end - list.first_watched(chunk);
    return of_active_contact * list.active.count[chunk] +
           of_watched_pair * watched / static_cast<double>(list.detection_interval);
}

}  // namespace

StepShares share_step(const Assemblage& a, const Boundary& boundary, const State* s, int n_threads) {
    StepShares shares{std::vector<StepShare>(static_cast<std::size_t>(n_threads)), {}};
    std::vector<double> on_nodes(shares.of_threads.size(), 0.0);
    std::vector<double> inner = on_nodes;  // before messages of other ranks come
    std::vector<double> outer = on_nodes;
    std::vector<double>& last = a.part.is_alone() ? inner : outer;
    const auto share = [&](const std::vector<std::int32_t>& chunks, StepShare::Chunks StepShare::*part, std::vector<double>& busy,
                           const auto& cost) {
        const auto ranges = level(
            chunks.size(), [&](std::int32_t i) { return cost(chunks[i]); }, busy);
        for (std::size_t t = 0; t < ranges.size(); ++t) {
            shares.of_threads[t].*part = StepShare::Chunks(chunks).subspan(ranges[t].begin, ranges[t].size());
        }
    };
    const auto& edges = boundary.prescribed.edges_of_chunk;
    const auto contacts = [&](std::int32_t k) { return cost_of_contacts(a.contact_chunks[k].contacts, s); };
    const auto elements = [&](std::int32_t k) { return of_element * a.element_chunks[k].size(); };
    const auto nodes = [&](std::int32_t k) {
        return of_node * a.node_chunks[k].nodes.size() + of_cluster * a.node_chunks[k].clusters.size() +
               of_platen_point * boundary.platen_points_of_chunk[k].size();
    };
    share(a.part.nodes.own, &StepShare::nodes, on_nodes, nodes);
    share(a.part.evaluated_contacts.inner, &StepShare::inner_contacts, inner, contacts);
    share(a.part.evaluated_contacts.outer, &StepShare::outer_contacts, outer, contacts);
    const auto pairs = level(
        s == nullptr ? 0 : s->contact_pairs.chunks.size(), [&](std::int32_t k) { return cost_of_pairs(s->contact_pairs, k); },
        last);
    for (std::size_t t = 0; t < pairs.size(); ++t) shares.of_threads[t].pairs = pairs[t];
    share(a.part.loaded_chunks, &StepShare::loaded, last,
          [&](std::int32_t k) { return edges.empty() ? 0 : of_loaded_edge * edges[k].size(); });
    // Chunks of elements are the smallest, so they level the differences that the others leave.
    share(a.part.evaluated_elements.inner, &StepShare::inner_elements, inner, elements);
    share(a.part.evaluated_elements.outer, &StepShare::outer_elements, outer, elements);
    shares.balance = {n_threads, busiest_over_mean(on_nodes), busiest_over_mean(last)};
    return shares;
}

}  // namespace graincrack
