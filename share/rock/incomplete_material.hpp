// Materials of which not everything is known yet: what is missing, a template to fill in, and the rock of laboratory values.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "share/rock/material.hpp"

namespace graincrack {

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
/// and K_IIC = 2 K_IC, as of Augig granite; the notes of the material say so.
void take_laboratory(IncompleteMaterial& material);

/// The rock for the fracture process zone from what a file has: [rock], else the same values of [laboratory], else, of a
/// toughness that nobody measured, that of `take_laboratory`. \param notes gets a sentence for each value that [rock] does not
/// give \throws InputError if E, ν or σt is in neither table
Rock rock_of_laboratory(const IncompleteMaterial& material, std::vector<std::string>& notes);

}  // namespace graincrack
