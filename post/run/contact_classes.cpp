#include "post/run/contact_classes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "share/base/error.hpp"

namespace graincrack {

namespace {

/// True if two names are those of one class.
bool same_class(const std::string& name, const std::string& other) {
    const std::size_t dash = name.find('-');
    return name == other || (dash != std::string::npos && name.substr(dash + 1) + "-" + name.substr(0, dash) == other);
}

}  // namespace

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

std::vector<bool> contacts_of_classes(const Specimen& specimen, const std::vector<std::string>& names, const std::string& file) {
    if (names.empty()) return std::vector<bool>(specimen.n_contacts(), true);
    const ContactClasses classes = classes_of(specimen);
    std::vector<bool> wanted(classes.names.size(), false);
    for (const std::string& name : names) {
        // All classes within crystals, or all between them.
        if (const bool is_within = name == "within"; is_within || name == "between") {
            for (std::size_t k = 0; k < wanted.size(); ++k) {
                if (!phase_of_within_class(classes.names[k]).empty() == is_within) wanted[k] = true;
            }
            if (std::ranges::find(wanted, true) != wanted.end()) continue;
        }
        const auto found = std::ranges::find_if(classes.names, [&](const std::string& each) { return same_class(each, name); });
        if (found == classes.names.end()) {
            throw UsageError(fmt::format("--class {}: {} has contacts of {} only", name, file, fmt::join(classes.names, ", ")));
        }
        wanted[static_cast<std::size_t>(found - classes.names.begin())] = true;
    }
    std::vector<bool> contacts;
    for (const std::size_t k : classes.of_contact) contacts.push_back(wanted[k]);
    return contacts;
}

std::vector<Crack> cracks_of(std::vector<Crack> cracks, const std::vector<bool>& contacts) {
    std::erase_if(cracks, [&](const Crack& crack) { return !contacts[static_cast<std::size_t>(crack.contact)]; });
    return cracks;
}

std::string limited_to(const std::string& text, const std::vector<std::string>& names) {
    std::vector<std::string> shown;
    for (const std::string& name : names) {
        shown.push_back(name == "within" || name == "between" ? "classes " + name + " crystals" : name);
    }
    return names.empty() ? text : fmt::format("{}; contacts of {} only", text, fmt::join(shown, ", "));
}

}  // namespace graincrack
