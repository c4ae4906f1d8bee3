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

/// Which contacts [c] are of the classes of some names, in each of which the phases may stand in either order; all without a
/// name. "within" stands for all classes within crystals, "between" for all others. \param file for the message \throws
/// UsageError for another name, with those that there are
std::vector<bool> contacts_of_classes(const Specimen& specimen, const std::vector<std::string>& names, const std::string& file);

/// The cracks of some contacts [c].
std::vector<Crack> cracks_of(std::vector<Crack> cracks, const std::vector<bool>& contacts);

/// The definition of the cracks of a picture that is limited to some classes: "TEXT; contacts of quartz-mica only".
std::string limited_to(const std::string& text, const std::vector<std::string>& names);

}  // namespace graincrack
