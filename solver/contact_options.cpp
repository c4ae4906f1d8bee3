#include "solver/contact_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

/// Names of the laws that fulfil a condition, "combined, consistent".
template <class Condition>
std::string laws_that(const Condition& condition) {
    std::string names;
    for (const LawDescription& law : all_contact_laws()) {
        if (condition(law)) names += (names.empty() ? "" : ", ") + std::string(law.name);
    }
    return names;
}
auto read_by(const ContactParameter& row) {
    return [&row](const LawDescription& law) { return row.every_law || law.reads(row.value); };
}

bool is_fracture_energy(const ContactParameter& row) { return row.value == &ContactParameters::fracture_energy; }

void add_parameters(OptionSet command, ContactOptions& o) {
    for (const ContactParameter& row : all_contact_parameters()) {
        const std::string usual = row.is_needed() ? "the material's" : fmt::format("the material's, else {}", row.usual);
        if (is_fracture_energy(row)) {
            add_fracture_energy(
                command, o.fracture_energy,
                fmt::format("{}: mixed (Eq 32), mode-i (K_IC^2/E~) or a value; default: {}", row.quantity.meaning, usual));
            continue;
        }
        const std::string laws = row.every_law ? "" : laws_that(read_by(row)) + ": ";
        add_quantity(command, row.option(), o.given.*row.given, row.quantity,
                     fmt::format("{}{}; default: {}", laws, row.quantity.meaning, usual));
    }
}

/// Refuses an option that is given and that the law has no use for.
template <class Condition>
void require_use(const std::string& option, LawVariant law, const Condition& uses) {
    if (uses(description_of(law))) return;
    throw UsageError(fmt::format("{}: the contact law {} does not use it; leave it out, or choose a law that uses it: {}", option,
                                 name_of(law), laws_that(uses)));
}

/// That its option and its key may have, J/m².
double largest_fracture_energy() {
    const auto& rows = all_contact_parameters();
    return std::find_if(rows.begin(), rows.end(), is_fracture_energy)->quantity.upper;
}

void require_energy(const char* option, double value, double least, LawVariant law) {
    if (value >= least) return;
    const std::string right = least > largest_fracture_energy() ? "a stiffer contact, or one of less strength"
                                                                : fmt::format("at least {} J/m2", format_number(least, 4));
    throw UsageError(fmt::format("{}: {} is less than a contact of the law {} absorbs up to its peak; give {}", option,
                                 format_quantity(value, Dimension::fracture_energy), name_of(law), right));
}

/// The law of a name. \throws UsageError, naming `where`
LawVariant law_named(const std::string& name, const std::string& where) {
    const auto& laws = all_contact_laws();
    const auto found = std::find_if(laws.begin(), laws.end(), [&](const LawDescription& law) { return law.name == name; });
    if (found == laws.end()) {
        throw UsageError(fmt::format("{}: unknown contact law \"{}\"; one of {} fits", where, name,
                                     laws_that([](const LawDescription&) { return true; })));
    }
    return found->variant;
}
LawVariant law_of(const ContactOptions& o, const Material& material) {
    if (!o.law.empty()) return law_named(o.law, "--contact-law");
    return material.law.empty() ? SimulationRequest{}.law : law_named(material.law, material.file.string() + ": contact.law");
}

void check_use(const ContactOptions& o, LawVariant law) {
    for (const ContactParameter& row : all_contact_parameters()) {
        const bool is_given = is_fracture_energy(row) ? o.fracture_energy.has_value() : (o.given.*row.given).has_value();
        if (is_given) require_use(row.option(), law, read_by(row));
    }
    const bool mixed = o.fracture_energy && o.fracture_energy->kind == FractureEnergyChoice::Kind::mixed;
    if (mixed && description_of(law).reads(&ContactParameters::mode_ii_fracture_energy)) {
        throw UsageError(fmt::format("--fracture-energy: the contact law {} has an energy for each mode; mode-i or a value fits",
                                     name_of(law)));
    }
}

void check_energies(const ContactParameters& p, LawVariant law) {
    const FractureEnergies least = min_fracture_energies(make_contact_law(p, law));
    require_energy("--fracture-energy", p.fracture_energy, least.opening, law);
    require_energy("--mode-ii-fracture-energy", p.mode_ii_fracture_energy, least.sliding, law);
}

}  // namespace

void add_contact_options(OptionSet command, ContactOptions& o) {
    add_text(command, "--material", o.material, "material: a name of share/materials or a TOML file")
        .required()
        .type_name("NAME");
    std::vector<std::string> laws;
    for (const LawDescription& law : all_contact_laws()) laws.emplace_back(law.name);
    add_choice(
        command, "--contact-law", o.law, laws,
        fmt::format("contact law; see share/doc/laws.md; default: the material's, else {}", name_of(SimulationRequest{}.law)));
    add_parameters(command, o);
    add_choice(command.usual(), "--plane", o.plane, {"strain", "stress"},
               "plane condition; default: strain, in Brazilian tests stress");
}

void apply_contact_options(const ContactOptions& o, SimulationRequest& request) {
    request.material = read_material(o.material);
    request.law = law_of(o, request.material);
    check_use(o, request.law);
    request.plane = o.plane.empty()       ? description_of(request.loading.test).plane
                    : o.plane == "stress" ? PlaneCondition::stress
                                          : PlaneCondition::strain;
    request.material.contact = overlay(o.given, request.material.contact);
    request.contact = contact_parameters(request.material, request.plane, o.fracture_energy);
    check_energies(request.contact, request.law);
    if (description_of(request.law).reads(&ContactParameters::bridging_strength)) {
        require_sound_bridges(request.contact, request.material.file.string() + ": [contact], with the options given");
    } else {
        request.contact.bridging_strength = request.contact.bridging_energy = 0;  // the run has none, and its file says so
    }
    const bool wears = request.contact.wear_slip > 0 && description_of(request.law).reads(&ContactParameters::wear_slip);
    if (wears && request.contact.residual_friction_angle >= request.contact.friction_angle) {
        throw InputError(
            request.material.file.string() +
            ": [contact], with the options given: wear_slip needs a residual_friction_angle below the friction_angle, "
            "to which faces wear");
    }
    request.fracture_energy = o.fracture_energy;
    request.fracture_energy_choice = description_of(request.law).reads(&ContactParameters::fracture_energy)
                                         ? name_of(effective_fracture_energy(request.material, o.fracture_energy).kind)
                                         : std::string_view("none");
}

}  // namespace graincrack
