#include "solver/model/contact_pairs.hpp"

namespace graincrack {

TouchList make_touch_list(const Assemblage& a) {
    TouchList list;
    list.loose.assign(2 * a.contacts.size(), 0);
    list.released.assign(a.contacts.size(), 0);
    list.gathers_of_block.assign(a.grain_blocks.size(), Range{});
    return list;
}

}  // namespace graincrack
