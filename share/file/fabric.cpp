#include "share/file/fabric.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <numbers>

#include "share/base/error.hpp"
#include "share/base/random_bits.hpp"

namespace graincrack {

void require_same_phases(const Material& material, const std::vector<std::string>& phase_names) {
    std::vector<std::string> described;
    for (const auto& [name, phase] : material.fabric.phases) described.push_back(name);
    if (described.empty() && phase_names.size() == 1) return;
    std::vector<std::string> present = phase_names;
    std::sort(present.begin(), present.end());
    if (present == described) return;
    throw InputError(
        fmt::format("the specimen has the phases {}, the material {} has {}; make the specimen with "
                    "graincrack-mesh … --material, or take another material",
                    fmt::join(present, ", "), material.file.string(),
                    described.empty() ? "none" : fmt::format("{}", fmt::join(described, ", "))));
}

namespace {

/// The two sides of a class of contacts.
struct ContactSides {
    const PhaseMaterial& first;
    const PhaseMaterial& second;
    double first_modulus, second_modulus;  ///< E of the grains, Pa
};

double by_rule(SideRule rule, double a, double b) { return rule == SideRule::mean ? 0.5 * (a + b) : std::min(a, b); }

/// Combines the values that a side overrides with those of the other side.
void take_sides(const ContactSides& sides, const Material& material, PlaneCondition plane, GivenContact& given) {
    const ContactParameters first = derived_contact(overlay(sides.first.contact, given), material.rock, plane);
    const ContactParameters second = derived_contact(overlay(sides.second.contact, given), material.rock, plane);
    for (const ContactParameter& row : all_contact_parameters()) {
        if (sides.first.contact.*row.given || sides.second.contact.*row.given) {
            given.*row.given = by_rule(material.fabric.rule, first.*row.value, second.*row.value);
        }
    }
}

void take_stiffness_of_sides(const ContactSides& sides, const Material& material, PlaneCondition plane, GivenContact& given) {
    const double harmonic = 2 / (1 / sides.first_modulus + 1 / sides.second_modulus);
    const double ratio = harmonic / material.rock.young_modulus;
    const ContactParameters of_rock = derived_contact(given, material.rock, plane);
    if (!given.normal_stiffness) given.normal_stiffness = ratio * of_rock.normal_stiffness;
    if (!given.shear_stiffness) given.shear_stiffness = ratio * of_rock.shear_stiffness;
}

void take_factors(const GivenContact& factors, const Material& material, PlaneCondition plane, GivenContact& given) {
    const ContactParameters before = derived_contact(given, material.rock, plane);
    for (const ContactParameter& row : all_contact_parameters()) {
        if (factors.*row.given) given.*row.given = *(factors.*row.given) * before.*row.value;
    }
}

/// Contact values given for a pair of phases. \param base values of [contact]
GivenContact given_between(const Material& material, PlaneCondition plane, const GivenContact& base, const std::string& a,
                           const std::string& b) {
    const MaterialFabric& fabric = material.fabric;
    const PhaseMaterial& first = fabric.phases.at(a);
    const PhaseMaterial& second = fabric.phases.at(b);
    const ContactSides sides{first, second, young_modulus_of_grains(first, fabric, material.rock),
                             young_modulus_of_grains(second, fabric, material.rock)};
    GivenContact given = base;
    take_sides(sides, material, plane, given);
    for (const std::string& pair : {a + "-" + b, b + "-" + a}) {
        if (const auto own = fabric.pairs.find(pair); own != fabric.pairs.end()) given = overlay(own->second, given);
    }
    if (fabric.stiffness == StiffnessRule::sides) take_stiffness_of_sides(sides, material, plane, given);
    take_factors(a == b ? fabric.homophase : fabric.heterophase, material, plane, given);
    return given;
}

Phase phase_of(const PhaseMaterial& phase, const Material& material) {
    const Rock& rock = material.rock;
    Phase made{young_modulus_of_grains(phase, material.fabric, rock), phase.poisson_ratio.value_or(rock.poisson_ratio),
               phase.density.value_or(rock.density), phase.thermal_expansion.value_or(0)};
    const auto curve = [](const ColumnsByTemperature& columns, const std::vector<double>& values) {
        TemperatureCurve made_curve;
        for (std::size_t i = 0; i < values.size(); ++i) made_curve.push_back({columns.temperatures[i], values[i]});
        return made_curve;
    };
    made.softening = curve(material.fabric.young_modulus_by_temperature, material.fabric.young_modulus_by_temperature.values);
    const ColumnsByTemperature& columns = phase.expansion_by_temperature;
    made.along = curve(columns, columns.values);
    made.across = columns.across.empty() ? made.along : curve(columns, columns.across);
    if (phase.expansion_along) made.along = {{0, *phase.expansion_along}};
    if (phase.expansion_across) made.across = {{0, *phase.expansion_across}};
    if (!made.along.empty()) made.thermal_expansion = value_at(made.along, 0).value;
    return made;
}

}  // namespace

std::vector<Phase> without_expansion(const std::vector<Phase>& phases) {
    std::vector<Phase> cold;
    for (const Phase& phase : phases) cold.push_back({phase.young_modulus, phase.poisson_ratio, phase.density});
    return cold;
}

std::vector<double> crystal_axes(const Specimen& specimen) {
    constexpr std::uint64_t stream = 999'998;
    const std::uint64_t key = mixed_bits(specimen.seed, stream);
    std::vector<double> angles;
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        const std::size_t crystal = specimen.grain_crystal.empty() ? g : static_cast<std::size_t>(specimen.grain_crystal[g]);
        angles.push_back(std::numbers::pi * uniform_of(mixed_bits(key, crystal)));
    }
    return angles;
}

Fabric fabric_of(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice,
                 const std::vector<std::string>& phase_names) {
    const MaterialFabric& fabric = material.fabric;
    const Rock& rock = material.rock;
    const GivenContact base = given_contact(material, plane, choice);
    if (fabric.phases.empty()) return uniform_fabric(rock, derived_contact(base, rock, plane), phase_names.size());
    require_same_phases(material, phase_names);
    Fabric made;
    for (const std::string& name : phase_names) made.phases.push_back(phase_of(fabric.phases.at(name), material));
    for (std::size_t high = 0; high < phase_names.size(); ++high) {
        for (std::size_t low = 0; low <= high; ++low) {
            made.contacts.push_back(
                derived_contact(given_between(material, plane, base, phase_names[low], phase_names[high]), rock, plane));
        }
    }
    return made;
}

ContactParameters flaw_contact(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice,
                               const std::string& flaw_name) {
    const auto own = material.fabric.flaws.find(flaw_name);
    if (own == material.fabric.flaws.end()) {
        throw InputError(fmt::format(
            "the specimen has flaws of the class {0}, and the material {1} no table [flaws.{0}]; add it, with what their "
            "contacts have other than [contact]",
            flaw_name, material.file.string()));
    }
    GivenContact given = given_contact(material, plane, choice);
    given.bridging_strength = given.bridging_energy = 0;  // joints do not interlock unless their table says so
    return derived_contact(overlay(own->second, given), material.rock, plane);
}

double length_within_crystals(const Specimen& specimen, const std::string& class_name) {
    const std::vector<std::string> names = contact_class_names(specimen);
    const std::vector<std::uint8_t> classes = contact_classes(specimen);
    double length = 0;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (names[classes[c]] == class_name) length += contact_length(specimen, c);
    }
    const std::string phase = phase_of_within_class(class_name);
    double area = 0;
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        if (specimen.phase_names[specimen.grain_phase[g]] == phase) area += specimen.grain_area[g];
    }
    return area > 0 ? length / area : 0;
}

ContactParameters contact_within_crystals(const Material& material, PlaneCondition plane,
                                          const std::optional<FractureEnergyChoice>& choice, const std::string& class_name,
                                          double length_per_area) {
    const MaterialFabric& fabric = material.fabric;
    const std::string phase = phase_of_within_class(class_name);
    const auto described = fabric.phases.find(phase);
    const bool is_rock = described == fabric.phases.end();
    const auto table = fabric.flaws.find(class_name);
    const bool has_table = table != fabric.flaws.end();

    GivenContact given = given_contact(material, plane, choice);
    if (!has_table && !is_rock) given = given_between(material, plane, given, phase, phase);
    take_factors(fabric.within, material, plane, given);
    if (has_table) {
        given = overlay(table->second, given);
    } else {
        // Values derived from stiffnesses use those of contacts between crystals.
        const ContactParameters between = derived_contact(given, material.rock, plane);
        for (const ContactParameter& row : all_contact_parameters()) given.*row.given = between.*row.value;
    }
    if (length_per_area > 0) {
        Rock mineral = material.rock;
        const Phase of_mineral = is_rock ? phase_of(material.rock) : phase_of(described->second, material);
        mineral.young_modulus = of_mineral.young_modulus;
        mineral.poisson_ratio = of_mineral.poisson_ratio;
        const fpz::ContactStiffness stiff =
            fpz::stiffness_of_added_compliance(mineral, plane, compliance_within_crystals, length_per_area);
        const auto take = [&](std::optional<double> GivenContact::*key, double value) {
            if (!has_table || !(table->second.*key)) given.*key = (fabric.within.*key).value_or(1) * value;
        };
        take(&GivenContact::normal_stiffness, stiff.normal);
        take(&GivenContact::shear_stiffness, stiff.shear);
    }
    return derived_contact(given, material.rock, plane);
}

}  // namespace graincrack
