#include "solver/model/contact_pairs.hpp"

namespace graincrack {

ContactPairList make_contact_pair_list(const Assemblage& a) {
    ContactPairList list;
    list.debonded.assign(2 * a.contacts.size(), 0);
    list.released.assign(a.contacts.size(), 0);
    list.node_forces_of_chunk.assign(a.grain_chunks.size(), Range{});
    return list;
}

}  // namespace graincrack
