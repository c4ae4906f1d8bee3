#include "post/run/comparable.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "share/base/error.hpp"
#include "share/file/specimen.hpp"

namespace graincrack {
namespace {

/// Relative difference below which two values are equal: the same strength, derived from other numbers in each plane
/// condition, differs in its last digits.
bool differs(double a, double b) { return std::abs(a - b) > 1e-9 * std::abs(b); }

/// True if a value of a class of contacts is of the specimen and not of the material: the stiffness within crystals is as large
/// as the length of the contacts there wants.
bool is_of_specimen(const RunHeader& header, std::size_t contact_class, const ContactParameter& row) {
    const bool is_stiffness =
        row.value == &ContactParameters::normal_stiffness || row.value == &ContactParameters::shear_stiffness;
    return is_stiffness && contact_class < header.class_names.size() &&
           !phase_of_within_class(header.class_names[contact_class]).empty();
}

}  // namespace

std::string material_difference(const RunHeader& a, const RunHeader& b) {
    if (a.contact_law != b.contact_law) return "the contact law";
    if (a.fracture_energy_choice != b.fracture_energy_choice) return "the choice of the fracture energy";
    if (a.rock.young_modulus != b.rock.young_modulus || a.rock.poisson_ratio != b.rock.poisson_ratio ||
        a.rock.density != b.rock.density) {
        return "the rock";
    }
    if (a.fabric.phases != b.fabric.phases) return "the phases";
    for (std::size_t k = 0; k < std::min(a.fabric.contacts.size(), b.fabric.contacts.size()); ++k) {
        for (const ContactParameter& row : all_contact_parameters()) {
            const bool is_compared = (!row.follows_plane || a.plane == b.plane) && !is_of_specimen(a, k, row);
            if (is_compared && differs(a.fabric.contacts[k].*row.value, b.fabric.contacts[k].*row.value)) {
                return "the contacts between phases";
            }
        }
    }
    for (const ContactParameter& row : all_contact_parameters()) {
        if (row.follows_plane && a.plane != b.plane) continue;
        if (differs(a.contact.*row.value, b.contact.*row.value)) {
            return row.follows_plane ? "the stiffness or fracture energy of the contacts" : "the contact parameters";
        }
    }
    return "";
}

std::string setting_difference(const RunHeader& a, const RunHeader& b) {
    if (a.plane != b.plane) return "the plane condition";
    // With an automatic rate the mean platen speed is a result, not a setting.
    if (a.rate != b.rate || a.rate_tolerance != b.rate_tolerance || a.rate_share != b.rate_share ||
        (a.rate != "auto" && a.platen_speed != b.platen_speed)) {
        return "the rate";
    }
    if (a.peak_drop != b.peak_drop) return "the drop behind the peak that ends the test";
    if (a.damping != b.damping) return "the damping";
    if (a.damping_form != b.damping_form) return "the form of the damping";
    // The factor of mass scaling depends on the specimen, so that only its kind is compared.
    if (a.mass_scaling != b.mass_scaling) return "the mass scaling";
    if (a.platen_friction != b.platen_friction) return "the friction of the platens";
    return "";
}

void require_same_settings(const std::vector<RunData>& runs, const std::string& what) {
    std::map<std::pair<std::string, double>, const RunData*> first;
    for (const RunData& run : runs) {
        const RunData& other = *first.try_emplace({run.header.test, run.header.confining_pressure}, &run).first->second;
        const std::string difference = setting_difference(run.header, other.header);
        if (difference.empty()) continue;
        throw InputError(run.name + ": differs from " + other.name + " in " + difference + "; " + what +
                         " needs tests of one kind that differ in their seeds only");
    }
}

void require_same_material(const RunData& run, const RunData& first, const std::string& what) {
    const std::string difference = material_difference(run.header, first.header);
    if (difference.empty()) return;
    throw InputError(run.name + ": differs from " + first.name + " in " + difference + "; " + what +
                     " needs tests of one material");
}

}  // namespace graincrack
