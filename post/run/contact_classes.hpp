// Classes of contacts by name: the pair of phases of the two grains of a contact.
#pragma once

#include <string>
#include <vector>

#include "share/file/run_file.hpp"

namespace graincrack {

/// The classes that have contacts in a specimen, by the names and in the order of /contacts/class.
struct ContactClasses {
    std::vector<std::string> names;
    std::vector<std::size_t> of_contact;  ///< [c] index into `names`
    [[nodiscard]] const std::string& name_of(const Crack& crack) const {
        return names[of_contact[static_cast<std::size_t>(crack.contact)]];
    }
};
ContactClasses classes_of(const Specimen& specimen);

}  // namespace graincrack
