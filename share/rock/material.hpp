// Materials: TOML files with a rock, its contacts and its laboratory values. Values may be missing.
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

/// [ratios] of a material: contact values that follow from others. They describe a rock type without values of a single rock, and
/// scale with the tensile strength in a calibration. The members are tensile_strength tc over the tensile strength of the rock;
/// cohesion and open_shear_strength over tc; fracture_energy as E G_I/tc² over the grain size, with E of the rock; and
/// mode_ii_fracture_energy over G_I. Other members are not used.
using ContactRatios = GivenContact;

/// The key of the measured K_IC, or of the table with its value and test.
inline constexpr const char* measured_toughness = "laboratory.mode_i_toughness";

/// [laboratory]: measured values, by key, in SI.
using LaboratoryValues = std::map<std::string, double>;

/// [fitted] of a calibrated material: the fitted properties of the assemblage by key (as in [laboratory], or
/// "confined_strength_8MPa"), with the values that they were fitted to in words.
using FittedProperties = std::map<std::string, std::string>;

struct Material {
    std::string name;
    std::string kind;            ///< rock type, a name of `rock_kinds`; "" if not given
    std::filesystem::path file;  ///< the file that it was read from
    Rock rock;
    GivenContact contact;              ///< [contact]; missing values follow from `ratios`, else from [rock]
    ContactRatios ratios;              ///< [ratios]
    std::string law;                   ///< [contact] law: name of its contact law; "" for that of the program
    GrainFabric grains;                ///< [fabric]
    MaterialFabric fabric;             ///< [phases], [pairs], [strength]
    double platen_friction_angle = 0;  ///< rad; 0 if the file has no [platen]
    LaboratoryValues laboratory;
    ToughnessTest toughness_test;  ///< test of mode_i_toughness of [laboratory]
    /// A value of [laboratory]; empty if it is not given.
    [[nodiscard]] std::optional<double> laboratory_value(const std::string& key) const;
    FittedProperties fitted;
    std::vector<Remark> notes;  ///< notes on values without a unit, warnings about values far from any rock's; see `write_notes`
};

/// Reads a material by name or file, as `materials` finds it. Quantities are texts with units ("25.8 GPa") or bare SI numbers.
/// Values missing in [rock] and [fabric] are those of [laboratory], by `take_laboratory`.
/// \throws InputError for a missing or malformed file, an unknown key, a missing property or a value out of bounds; the
///         message names file, key and what is allowed
Material read_material(const std::string& name_or_file);

/// A material file in which needed keys may be missing; their values are 0.
struct IncompleteMaterial {
    Material material;
    std::vector<std::string> missing;      ///< "rock.density", in the order of the template
    std::map<std::string, double> values;  ///< values of the file by key, "rock.density"; SI
};
/// Reads a material that may lack keys. \throws InputError for all other errors of `read_material`
IncompleteMaterial read_incomplete_material(const std::string& name_or_file);

/// Every key of a material file, "rock.young_modulus", in the order of the template.
std::vector<std::string> material_keys();

/// A key of a material file, "rock.young_modulus", "phases.quartz.fraction", which sets nothing. \throws UsageError likewise
TomlKey material_key(const std::string& key);
/// The quantity of a key, "rock.young_modulus". \throws UsageError with the nearest key and all keys if there is none
Quantity material_quantity(const std::string& key);

/// Gives a material the values that it lacks from its [laboratory]: values of [rock], and the grain size of a [fabric] with a
/// tessellation. If the tensile strength of the rock comes from there, a toughness that was not measured is K_IC = σt/6.88 MPa√m
/// (Zhang 2002) and K_IIC = 2 K_IC, as for Augig granite.
void take_laboratory(IncompleteMaterial& material);

/// The rock for the fracture process zone: values of [rock], else of [laboratory], else, for a toughness that was not measured,
/// as in `take_laboratory`. \param notes gets a sentence for each value that [rock] does not give \throws InputError if E, ν or
/// σt is in neither table
Rock rock_of_laboratory(const IncompleteMaterial& material, std::vector<std::string>& notes);

/// Writes the notes on the values of a material, one line per note: "PROGRAM: note: …".
void write_notes(std::ostream& out, std::string_view program, const Material& material);

/// The choice of the fracture energy of a contact (--fracture-energy).
struct FractureEnergyChoice {
    enum class Kind { mixed, mode_i, value } kind = Kind::mode_i;
    double value = 0;  ///< J/m², for Kind::value
};

/// Reads "mixed", "mode-i" or a value such as "90J/m2". \throws UsageError that names `where`
FractureEnergyChoice parse_fracture_energy(std::string_view text, std::string_view where);
/// "mixed", "mode-i" or "value".
std::string_view name_of(FractureEnergyChoice::Kind kind);

/// The choice of `contact_parameters`: `choice`, else the material's own value, else mode-i.
FractureEnergyChoice effective_fracture_energy(const Material& material, const std::optional<FractureEnergyChoice>& choice);

/// The contact values that a material gives: [contact], with an explicit choice of the fracture energy, and the values that
/// follow from [ratios].
GivenContact given_contact(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice);

/// The contact parameters of a material by `derived_contact`. An explicit `choice` takes precedence over the material's own
/// fracture energy; without either the choice is mode-i.
ContactParameters contact_parameters(const Material& material, PlaneCondition plane,
                                     const std::optional<FractureEnergyChoice>& choice);

}  // namespace graincrack
