// Materials: TOML files with the rock, its contacts and its laboratory values.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "share/fracture_process_zone.hpp"
#include "share/quantities.hpp"

namespace graincrack {

/// [contact]: microparameters of the grain boundaries. What is unset is derived from [rock].
struct ContactMaterial {
    double tensile_strength = 0;             ///< tc, Pa
    double cohesion = 0;                     ///< cc, Pa
    double friction_angle = 0;               ///< φc, rad
    std::optional<double> normal_stiffness;  ///< kt, Pa/m
    std::optional<double> shear_stiffness;   ///< ks, Pa/m
    std::optional<double> fracture_energy;   ///< Gf, J/m²
    // used by some laws only
    std::optional<double> mode_ii_fracture_energy;    ///< G_II, J/m²
    std::optional<double> open_shear_strength;        ///< Pa
    std::optional<double> residual_tensile_strength;  ///< Pa
    std::optional<double> residual_cohesion;          ///< Pa
    std::optional<double> residual_friction_angle;    ///< rad
};

/// [laboratory]: measured values, by key, in SI; not read by the solver.
using LaboratoryValues = std::map<std::string, double>;

/// [fitted] of a calibrated material: properties of the assemblage that were fitted, by key (as in [laboratory], or
/// "confined_strength_8MPa"), and to what, in words.
using FittedProperties = std::map<std::string, std::string>;

struct Material {
    std::string name;
    std::filesystem::path file;  ///< where it was read from
    Rock rock;
    ContactMaterial contact;
    double platen_friction_angle = 0;  ///< rad; 0 if the file has no [platen]
    LaboratoryValues laboratory;
    FittedProperties fitted;
    std::vector<std::string> notes;  ///< on its values, for stderr: "note: …" without a unit, "warning: …" far off any rock's
};

/// Keys [laboratory] may hold: young_modulus, poisson_ratio, tensile_strength, compressive_strength, cohesion,
/// friction_angle, grain_size, min_grain_size, max_grain_size.
const std::vector<Quantity>& laboratory_quantities();

/// Reads a material. `name_or_file` is a path if it contains '/', ends in ".toml" or is a file; else a name looked up as
/// NAME.toml in the folder $GRAINCRACK_MATERIALS, in the place where the program's installation keeps materials and in
/// share/materials of the source tree, in this order. Quantities are texts with units ("25.8 GPa") or bare SI numbers.
/// \throws InputError for a missing or malformed file, an unknown key, a missing property or a value out of bounds; the
///         message names file and key and says what would be right.
Material read_material(const std::string& name_or_file);

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

/// All parameters of a contact, derived: what a law needs.
struct ContactParameters {
    double normal_stiffness = 0;  ///< kt, Pa/m
    double shear_stiffness = 0;   ///< ks, Pa/m
    double tensile_strength = 0;  ///< tc, Pa
    double cohesion = 0;          ///< cc, Pa
    double friction_angle = 0;    ///< φc, rad
    double fracture_energy = 0;   ///< Gf, J/m²
    double critical_opening = 0;  ///< δct, m (Eq 8)
    double critical_sliding = 0;  ///< δcs, m (Eq 11)
    double ultimate_opening = 0;  ///< δut, m (Eq 14); below δct if Gf is too small for a law with this branch
    // used by some laws only
    double mode_ii_fracture_energy = 0;    ///< G_II, J/m²; K_IIC²/Ẽ unless given
    double residual_tensile_strength = 0;  ///< after failure, Pa
    double residual_cohesion = 0;          ///< after failure, Pa
    double residual_friction_angle = 0;    ///< after failure, rad; φc unless given
    double open_shear_strength = 0;        ///< while open, Pa; tc √(ks/kt) unless given
};

/// Derives the contact parameters of a material for a plane condition (Eqs 3–5, 8, 11, 14, 32).
/// An explicit `choice` takes precedence over the material's own fracture energy; without either the choice is mode-i. Each law
/// checks for itself whether the fracture energies suffice for its curves.
ContactParameters contact_parameters(const Material& material, PlaneCondition plane,
                                     const std::optional<FractureEnergyChoice>& choice);

}  // namespace graincrack
