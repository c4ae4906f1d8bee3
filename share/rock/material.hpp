// Materials: TOML files with the rock, its contacts and its laboratory values, of which not everything need be known yet.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "share/base/events.hpp"
#include "share/base/quantities.hpp"
#include "share/rock/contact_parameters.hpp"
#include "share/rock/fracture_process_zone.hpp"
#include "share/rock/material_fabric.hpp"
#include "share/rock/toughness_test.hpp"

namespace graincrack {

/// [ratios] of a material: contact values that follow from others, so that a kind of rock is described without numbers of one
/// rock, and a calibration that moves the tensile strength takes the others with it. By the contact value that follows:
/// tensile_strength tc over the tensile strength of the rock; cohesion and open_shear_strength over tc; fracture_energy E G_I/tc²
/// over the grain size, with E of the rock; mode_ii_fracture_energy over G_I. Other members are not used.
using ContactRatios = GivenContact;

/// The key of the measured K_IC, or the table of its value and of the test that it is of.
inline constexpr const char* measured_toughness = "laboratory.mode_i_toughness";

/// [laboratory]: measured values, by key, in SI.
using LaboratoryValues = std::map<std::string, double>;

/// [fitted] of a calibrated material: properties of the assemblage that were fitted, by key (as in [laboratory], or
/// "confined_strength_8MPa"), and to what, in words.
using FittedProperties = std::map<std::string, std::string>;

struct Material {
    std::string name;
    std::string kind;            ///< of rock, a name of `rock_kinds`; "": not given
    std::filesystem::path file;  ///< where it was read from
    Rock rock;
    GivenContact contact;              ///< [contact]; what is unset follows from `ratios`, else from [rock]
    ContactRatios ratios;              ///< [ratios]
    std::string law;                   ///< [contact] law: name of its contact law; "": that of the program
    GrainFabric grains;                ///< [fabric]
    MaterialFabric fabric;             ///< [phases], [pairs], [strength]
    double platen_friction_angle = 0;  ///< rad; 0 if the file has no [platen]
    LaboratoryValues laboratory;
    ToughnessTest toughness_test;  ///< of mode_i_toughness of [laboratory]
    /// A value of [laboratory]; empty if it has none.
    [[nodiscard]] std::optional<double> laboratory_value(const std::string& key) const;
    FittedProperties fitted;
    std::vector<Remark> notes;  ///< on its values, for `write_notes`: notes of those without a unit, warnings far off any rock's
};

/// Reads a material, a name or a file as `materials` finds it. Quantities are texts with units ("25.8 GPa") or bare SI numbers.
/// What [rock] and [fabric] do not give is that of [laboratory], as `take_laboratory` has it.
/// \throws InputError for a missing or malformed file, an unknown key, a missing property or a value out of bounds; the
///         message names file and key and says what would be right.
Material read_material(const std::string& name_or_file);

/// A material file of which needed keys may be missing; those are 0.
struct IncompleteMaterial {
    Material material;
    std::vector<std::string> missing;      ///< "rock.density", in the order of the template
    std::map<std::string, double> values;  ///< what the file has, by key, "rock.density"; SI
};
/// Reads a material as `read_material` does, without asking for all keys. \throws InputError as there for everything else
IncompleteMaterial read_incomplete_material(const std::string& name_or_file);

/// Every key of a material file, "rock.young_modulus", in the order of the template.
std::vector<std::string> material_keys();

/// A key of a material file, "rock.young_modulus", "phases.quartz.fraction"; it sets nothing of use. \throws UsageError likewise
TomlKey material_key(const std::string& key);
/// What a key of a material file holds, "rock.young_modulus". \throws UsageError with the nearest and all keys if there is none
Quantity material_quantity(const std::string& key);

/// Gives a material what it lacks and its laboratory has: values of [rock], and the grain size of a [fabric] with a tessellation.
/// Where the tensile strength of the rock comes from there, a toughness that nobody measured is K_IC = σt/6.88 MPa√m (Zhang 2002)
/// and K_IIC = 2 K_IC, as of Augig granite.
void take_laboratory(IncompleteMaterial& material);

/// The rock for the fracture process zone from what a file has: [rock], else the same values of [laboratory], else, of a
/// toughness that nobody measured, that of `take_laboratory`. \param notes gets a sentence for each value that [rock] does not
/// give \throws InputError if E, ν or σt is in neither table
Rock rock_of_laboratory(const IncompleteMaterial& material, std::vector<std::string>& notes);

/// Says the notes on the values of a material, a line each: "PROGRAM: note: …".
void write_notes(std::ostream& out, std::string_view program, const Material& material);

/// How the fracture energy of a contact is chosen (--fracture-energy).
struct FractureEnergyChoice {
    enum class Kind { mixed, mode_i, value } kind = Kind::mode_i;
    double value = 0;  ///< J/m², for Kind::value
};

/// Reads "mixed", "mode-i" or a value such as "90J/m2". \throws UsageError naming `where`
FractureEnergyChoice parse_fracture_energy(std::string_view text, std::string_view where);
/// "mixed", "mode-i" or "value".
std::string_view name_of(FractureEnergyChoice::Kind kind);

/// The choice `contact_parameters` makes: `choice`; else the material's own value; else mode-i.
FractureEnergyChoice effective_fracture_energy(const Material& material, const std::optional<FractureEnergyChoice>& choice);

/// What a material gives of its contacts: [contact] with an explicit choice of the fracture energy in place of its own, and what
/// its [ratios] make of that.
GivenContact given_contact(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice);

/// The contact parameters of a material, as `derived_contact` has them. An explicit `choice` takes precedence over the material's
/// own fracture energy; without either the choice is mode-i.
ContactParameters contact_parameters(const Material& material, PlaneCondition plane,
                                     const std::optional<FractureEnergyChoice>& choice);

}  // namespace graincrack
