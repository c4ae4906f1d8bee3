#include "post/run/contact_classes.hpp"

#include <algorithm>

namespace graincrack {

ContactClasses classes_of(const Specimen& specimen) {
    const std::vector<std::string> all = contact_class_names(specimen);
    const std::vector<std::uint8_t> of_contact = contact_classes(specimen);
    std::vector<std::size_t> index(all.size());
    ContactClasses classes;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (std::ranges::find(of_contact, k) == of_contact.end()) continue;
        index[k] = classes.names.size();
        classes.names.push_back(all[k]);
    }
    for (const std::uint8_t k : of_contact) classes.of_contact.push_back(index[k]);
    return classes;
}

}  // namespace graincrack
