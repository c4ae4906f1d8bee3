#include "post/commands/commands.hpp"

#include <fmt/ostream.h>

#include <array>
#include <cmath>
#include <numbers>

#include "post/fit/paper_rock.hpp"
#include "post/options/command.hpp"
#include "share/base/events.hpp"
#include "share/base/units.hpp"
#include "share/options/option_set.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

namespace {

/// Mean edges that the paper can be read to mean, m: 4 mm by its text, 5.13 mm by its 1,122 grains in 80 mm × 160 mm.
constexpr std::array<double, 2> mean_edges_of_paper{4.0e-3, 5.13e-3};

/// The known values of a rock: all of them, or its laboratory values alone, without those of its contacts.
struct KnownRock {
    Material material;
    std::vector<double> edges;  ///< mean edges of the grains, m
    [[nodiscard]] GivenContact contact(PlaneCondition plane) const { return given_contact(material, plane, std::nullopt); }
};

void write_plane(TableWriter& table, const KnownRock& known, PlaneCondition condition) {
    const Rock& rock = known.material.rock;
    const GivenContact contact = known.contact(condition);
    const std::string plane(name_of(condition));
    const double kt = fpz::normal_stiffness(rock, condition);
    const double ks = fpz::shear_stiffness(rock, condition);
    table.row({"effective_modulus", plane, fpz::effective_modulus(rock, condition) * 1e-9, "GPa", "32"});
    table.row({"mode_i_zone_thickness", plane, fpz::mode_i_zone_thickness(rock, condition) * 1e3, "mm", "33"});
    table.row({"mode_ii_zone_thickness", plane, fpz::mode_ii_zone_thickness(rock, condition) * 1e3, "mm", "34"});
    // Eqs 3–6: k = modulus/thickness, written out in plane stress and plane strain.
    table.row({"contact_normal_stiffness", plane, kt * 1e-9, "MPa/mm", "3-6"});
    table.row({"contact_shear_stiffness", plane, ks * 1e-9, "MPa/mm", "3-6"});
    table.row({"stiffness_ratio", plane, ks / kt, "1", "3-6"});
    if (contact.tensile_strength) {
        const double critical_opening = fpz::critical_displacement(*contact.tensile_strength, kt);
        table.row({"critical_opening", plane, critical_opening * 1e3, "mm", "8"});
    }
    if (contact.cohesion) {
        table.row({"critical_sliding", plane, fpz::critical_displacement(*contact.cohesion, ks) * 1e3, "mm", "11"});
    }
    const auto energy = [&](const std::string& name, double value, const std::string& equation) {
        table.row({name + "_fracture_energy", plane, value, "J/m2", equation});
        if (!contact.tensile_strength) return;
        const double tc = *contact.tensile_strength;
        const double opening = fpz::ultimate_displacement(value, tc, fpz::critical_displacement(tc, kt));
        table.row({name + "_ultimate_opening", plane, opening * 1e3, "mm", "14"});
        table.row({name + "_contact_zone_length", plane, fpz::contact_zone_length(rock, condition, value, tc) * 1e3, "mm",
                   "16 with the contact's strength: (9 pi/32) E~ Gf/tc^2"});
    };
    energy("mixed_mode", fpz::mixed_mode_fracture_energy(rock, condition), "32");
    energy("mode_i", fpz::mode_i_fracture_energy(rock, condition), "32 with K_IC alone");
    if (contact.fracture_energy) energy("contact_mode_i", *contact.fracture_energy, "of the material");
    if (contact.mode_ii_fracture_energy) {
        table.row({"contact_mode_ii_fracture_energy", plane, *contact.mode_ii_fracture_energy, "J/m2", "of the material"});
    }
}

void write_grain_size(TableWriter& table, const Rock& rock) {
    table.row({"zone_length", "", fpz::zone_length(rock) * 1e3, "mm", "16"});
    table.row({"min_grain_size", "", fpz::min_grain_size(rock) * 1e3, "mm", "15, 17"});
    table.row({"min_grain_size_shear", "", fpz::min_grain_size_shear(rock) * 1e3, "mm", "15, 17 with w_II"});
    table.row({"max_grain_size", "", fpz::max_grain_size(rock) * 1e3, "mm", "15, 17"});
}

/// Table 9: b(m, n), and the zone thickness that follows from it.
void write_lennard_jones(TableWriter& table, const Rock& rock) {
    const double energy = fpz::mixed_mode_fracture_energy(rock, PlaneCondition::strain);
    for (int m = 8; m <= 12; ++m) {
        for (int n = 13; n <= 18; ++n) {
            const double b = fpz::lennard_jones_b(m, n);
            table.row({fmt::format("lennard_jones_b({},{})", m, n), "", b, "1", "31"});
            table.row({fmt::format("lennard_jones_zone_thickness({},{})", m, n), "strain",
                       fpz::zone_thickness(energy, b, rock.tensile_strength) * 1e3, "mm", "30"});
        }
    }
}

/// Appendix 2: strengths of contact and rock, for each mean edge.
void write_macro_micro(TableWriter& table, const KnownRock& known) {
    const Rock& rock = known.material.rock;
    const GivenContact contact = known.contact(PlaneCondition::strain);
    for (const double edge : known.edges) {
        const std::string suffix = fmt::format("({:.4g} mm)", edge * 1e3);
        const double force = rock.mode_i_toughness * std::sqrt(edge / std::numbers::pi);
        const double strength = fpz::contact_tensile_strength_from_toughness(rock.mode_i_toughness, edge);
        table.row({"first_contact_force_at_toughness" + suffix, "", force * 1e-3, "kN/m", "35-38"});
        table.row({"contact_tensile_strength_from_toughness" + suffix, "", strength * 1e-6, "MPa", "39, 40"});
        if (contact.tensile_strength) {
            const double tc = *contact.tensile_strength;
            table.row({"mode_i_toughness_over_contact_strength" + suffix, "", rock.mode_i_toughness / (tc * std::sqrt(edge)), "1",
                       "41"});
        }
        if (contact.cohesion) {
            table.row({"mode_ii_toughness_over_contact_cohesion" + suffix, "",
                       rock.mode_ii_toughness / (*contact.cohesion * std::sqrt(edge)), "1", "42"});
        }
        if (contact.tensile_strength) {
            table.row({"tensile_strength_over_contact_strength" + suffix, "",
                       rock.tensile_strength / (*contact.tensile_strength * std::sqrt(edge)), "1/m^0.5", "44"});
        }
    }
    table.row(
        {"tensile_strength_from_toughness", "", fpz::tensile_strength_from_toughness(rock.mode_i_toughness) * 1e-6, "MPa", "43"});
}

/// Table quantity, plane, value, unit, equation (of Kazerani & Zhao 2014): Eqs 3–6, 8, 11, 14–17 and 30–44. `plane` is
/// "strain" or "stress", empty for what does not depend on it.
void write_fpz_table(std::ostream& out, const KnownRock& known, TableFormat format) {
    TableWriter table(out, {"quantity", "plane", "value", "unit", "equation"}, format);
    table.row({"shear_modulus", "", fpz::shear_modulus(known.material.rock) * 1e-9, "GPa", "3-6"});
    write_plane(table, known, PlaneCondition::strain);
    write_plane(table, known, PlaneCondition::stress);
    write_grain_size(table, known.material.rock);
    write_lennard_jones(table, known.material.rock);
    write_macro_micro(table, known);
}

struct FpzOptions {
    std::string material;
    std::vector<double> edges;
};

/// The edges that were asked for; else those of the paper for its rock, else the laboratory's grain size, if there is one.
std::vector<double> edges_of(const FpzOptions& options, const Material& material) {
    if (!options.edges.empty()) return options.edges;
    if (is_rock_of_paper(material.name)) return {mean_edges_of_paper.begin(), mean_edges_of_paper.end()};
    const auto measured = material.laboratory.find("grain_size");
    return measured == material.laboratory.end() ? std::vector<double>{} : std::vector<double>{measured->second};
}

/// \param notes gets a sentence for each value that was not measured
KnownRock known_rock(const IncompleteMaterial& read, const FpzOptions& options, std::vector<std::string>& notes) {
    KnownRock rock{read.material, edges_of(options, read.material)};
    rock.material.rock = rock_of_laboratory(read, notes);
    if (!rock.contact(PlaneCondition::strain).tensile_strength) {
        notes.emplace_back("contact.tensile_strength is missing: quantities that follow from it are left out");
    }
    if (rock.edges.empty()) {
        notes.emplace_back("no grain size: give --edge or laboratory.grain_size for the quantities that depend on it");
    }
    return rock;
}

}  // namespace

Command fpz_command() {
    return make_command<FpzOptions>(
        "fpz", "fracture process zone of a rock, each quantity with its equation; laboratory values are sufficient",
        {"--material augig-granite", "--material augig-granite --edge 2mm --edge 4mm --format jsonl"}, std::nullopt,
        [](OptionSet set, FpzOptions& options) {
            add_text(set, "--material", options.material, "material: a name of share/materials or a TOML file").required();
            const auto add_edge = [&options](const std::string& text) {
                options.edges.push_back(parse_quantity(text, quantity::mean_edge, "--edge"));
                note_bare_number(text, quantity::mean_edge, "--edge");
            };
            add_value(set, "--edge", add_edge, quantity::mean_edge,
                      "mean edge of the grains; may be given again; default: the grain size of the laboratory", "LENGTH")
                .repeatable();
        },
        [](const FpzOptions& options, const Call& call) {
            std::vector<std::string> notes;
            const KnownRock rock = known_rock(read_incomplete_material_of(call, options.material), options, notes);
            write_fpz_table(call.out, rock, call.format);
            for (const std::string& note : notes) say(call.diagnostics(), fmt::format("fpz: note: {}", note));
        },
        Prints::table);
}

}  // namespace graincrack
