#include "post/cracks/crack_network.hpp"

#include <algorithm>

namespace graincrack {

std::vector<std::size_t> corners_of_nodes(const Specimen& specimen) {
    UnionFind same(specimen.n_nodes());
    for (const auto& nodes : specimen.contact_nodes) {
        same.join(static_cast<std::size_t>(nodes[0]), static_cast<std::size_t>(nodes[2]));
        same.join(static_cast<std::size_t>(nodes[1]), static_cast<std::size_t>(nodes[3]));
    }
    std::vector<std::size_t> corners(specimen.n_nodes());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = same.find(i);
    return corners;
}

CrackNetwork::CrackNetwork(const Specimen& specimen)
    : specimen_(specimen),
      corner_(corners_of_nodes(specimen)),
      sets_(specimen.n_nodes() + specimen.n_contacts()),
      reach_(specimen.n_nodes() + specimen.n_contacts()) {}

void CrackNetwork::Reach::include(const Reach& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
}

CrackNetwork::Reach CrackNetwork::reach_of(const Crack& crack) const {
    if (crack.mode != CrackMode::tensile) return {};
    const auto& nodes = specimen_.contact_nodes[static_cast<std::size_t>(crack.contact)];
    const auto height = [&](std::size_t k) { return specimen_.node_position[static_cast<std::size_t>(nodes[k])][1]; };
    const double end = height(crack.point);
    const double middle = (height(0) + height(1)) / 2;
    return {std::min(end, middle), std::max(end, middle)};
}

double CrackNetwork::add(const Crack& crack) {
    const auto contact = static_cast<std::size_t>(crack.contact);
    const auto node = static_cast<std::size_t>(specimen_.contact_nodes[contact][crack.point]);
    const std::size_t corner = sets_.find(corner_[node]);
    const std::size_t middle = sets_.find(specimen_.n_nodes() + contact);
    Reach joined = reach_of(crack);
    joined.include(reach_[corner]);
    joined.include(reach_[middle]);
    sets_.join(corner, middle);
    reach_[sets_.find(corner)] = joined;
    return std::max(joined.high - joined.low, 0.0);
}

}  // namespace graincrack
