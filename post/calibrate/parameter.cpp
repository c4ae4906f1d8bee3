#include "post/calibrate/parameter.hpp"

#include <fmt/format.h>
#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>

#include "post/fit/mohr_coulomb.hpp"
#include "share/base/error.hpp"
#include "share/base/toml_table.hpp"
#include "share/base/units.hpp"

namespace graincrack::calibrate {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr Quantity part_of_first{"part", Dimension::one, 0, 100, "part of the first guess", true};

/// Properties that default boxes follow from.
struct Basis {
    const Material& rock;
    double edge;
    double ucs;             ///< NaN if the laboratory has none; its boxes then have no defaults
    double friction_angle;  ///< of the rock
    bool frictional;        ///< law `cohesive-frictional`, whose friction adds to its cohesion
    bool crystals;          ///< that break, with that law
    bool wears;             ///< has friction that wears, whose residual value is one of worn faces
};

/// Which materials a row is of: those of other laws than `cohesive-frictional`, those of that law, of these those of crystals
/// that break, and those whose friction wears. A later row replaces an earlier one.
enum class Of { all, others, frictional, crystals, worn };
bool holds(Of materials, const Basis& b) {
    if (materials == Of::others) return !b.frictional;
    if (materials == Of::worn) return b.wears;
    return materials == Of::all || (b.frictional && (materials == Of::frictional || b.crystals));
}

/// A default box about a first guess, as parts of a reference. The limits of boxes that move are wider; of angles they are 5° and
/// 75°.
struct DefaultBox {
    const char* key;
    Of materials;
    bool is_free;  ///< a parameter unless [parameters] say otherwise
    double (*reference)(const Basis& basis);
    double first, low, high, least, most;
    const char* source;
    [[nodiscard]] bool is_angle() const { return std::string_view(key).ends_with("angle"); }
    [[nodiscard]] Parameter of(const Basis& basis) const {
        const double unit = reference(basis);
        if (is_angle()) return {key, false, unit * low, unit * high, 5 * degree, 75 * degree, unit * first, source};
        return {key, true, unit * low, unit * high, unit * least, unit * most, unit * first, source};
    }
};

double rock_tension(const Basis& b) { return b.rock.rock.tensile_strength; }
double ucs(const Basis& b) { return b.ucs; }
double rock_friction(const Basis& b) { return b.friction_angle; }
double worn_friction(const Basis& b) { return b.rock.contact.residual_friction_angle.value_or(NAN); }
double tension_of_toughness(const Basis& b) {
    return fpz::contact_tensile_strength_from_toughness(b.rock.rock.mode_i_toughness, b.edge);
}
/// K_IC² / Ẽ: what a notch that is long enough to measure K_IC would want of G_I.
double energy_of_toughness(const Basis& b) { return fpz::mode_i_fracture_energy(b.rock.rock, PlaneCondition::strain); }
double stiffness_of_zone(const Basis& b) { return fpz::normal_stiffness(b.rock.rock, PlaneCondition::strain); }
/// The contrast by which the moduli of grains have a coefficient of variation of 1. Published tables of moduli of granite's
/// minerals have 0.17 to 0.32.
double contrast_of_variation(const Basis& b) {
    double mean = 0;
    double square = 0;
    for (const auto& [name, phase] : b.rock.fabric.phases) {
        const double r = relative_young_modulus(phase, b.rock.rock);
        mean += phase.fraction * r;
        square += phase.fraction * r * r;
    }
    const double variation = std::sqrt(square - mean * mean) / mean;
    return variation > 0 ? 1 / variation : NAN;
}

constexpr const char* below_intact = "0.7 φ, somewhat below that of intact contacts";
constexpr const char* contrast = "phases.contrast";
constexpr DefaultBox default_boxes[] = {
    {"contact.tensile_strength", Of::others, true, tension_of_toughness, 1, 0.5, 2, 0.1, 4, "2 K_IC/√(π dp), Eq 40"},
    {"contact.tensile_strength", Of::frictional, true, rock_tension, 0.9, 0.6, 1.4, 0.2, 3, "0.9 of the Brazilian strength"},
    {"contact.cohesion", Of::others, true, ucs, 0.5, 0.25, 1, 0.05, 3, "UCS/2, the centre of Kazerani & Zhao's design"},
    {"contact.cohesion", Of::frictional, true, ucs, 0.3, 0.15, 0.6, 0.03, 1.5, "0.3 UCS, because friction adds to it"},
    {"contact.friction_angle", Of::others, true, rock_friction, 0.7, 0.45, 0.95, 0, 0,
     "0.7 φ: specimens are rougher than their contacts"},
    {"contact.friction_angle", Of::frictional, true, rock_friction, 0.85, 0.65, 1.05, 0, 0, "0.85 φ"},
    {"contact.residual_friction_angle", Of::others, false, rock_friction, 0.7, 0.5, 0.9, 0, 0, below_intact},
    {"contact.residual_friction_angle", Of::frictional, true, rock_friction, 0.7, 0.5, 0.9, 0, 0, below_intact},
    {"contact.residual_friction_angle", Of::crystals, true, rock_friction, 0.57, 0.4, 0.75, 0, 0,
     "0.57 φ, of crystals that break"},
    {"contact.residual_friction_angle", Of::worn, false, worn_friction, 1, 0.5, 2, 0, 0, "the material's own, of worn faces"},
    {"contact.fracture_energy", Of::all, false, energy_of_toughness, 0.75, 0.5, 1, 0.5, 1,
     "½ to 1 K_IC²/Ẽ, so that K_IC stays the rock's"},
    {"contact.open_shear_strength", Of::all, false, rock_tension, 3, 1, 9, 0.3, 30, "3 times the Brazilian strength"},
    {"contact.normal_stiffness", Of::all, false, stiffness_of_zone, 1, 0.3, 3, 0.01, 10, "E / w_I, Eqs 3-5"},
    {contrast, Of::all, false, contrast_of_variation, NAN, 0.17, 0.32, 0.17, 0.32,
     "coefficients of variation of published moduli, 0.17 to 0.32"}};

/// The last row of a key that holds for a material; null if there is none.
const DefaultBox* default_box(const Basis& basis, std::string_view key) {
    const auto fits = [&](const DefaultBox& box) { return key == box.key && holds(box.materials, basis); };
    const auto last = std::find_if(std::rbegin(default_boxes), std::rend(default_boxes), fits);
    return last == std::rend(default_boxes) ? nullptr : &*last;
}

Basis basis_of(const Material& rock, double edge) {
    const auto of = [&](const char* key) { return rock.laboratory_value(key).value_or(NAN); };
    const bool wears = rock.contact.wear_slip.value_or(0) > 0;
    Basis basis{rock, edge, of("compressive_strength"), of("friction_angle"), rock.law == "cohesive-frictional", false, wears};
    basis.crystals = basis.frictional && rock.grains.tessellation == "trigon";
    if (const auto b = laboratory_slope(rock); b && std::isnan(basis.friction_angle)) {
        basis.friction_angle = friction_angle_of(*b);
    }
    return basis;
}

/// Ratios with a box whatever the material has; first guesses where it has none.
const Parameter ratio_boxes[] = {
    {"ratios.process_zone", true, 0.3, 3, 0.1, 10, 0.7, "process zones about as long as grains"},
    {"ratios.bridging_strength", false, 0.3, 0.8, 0.05, 0.95, 0.55, "bridges bear about half of the tensile strength"},
    {"ratios.bridging_energy", true, 0.3, 2, 0.1, 5, 1, "bridges give the rock its K_IC"},
    {"pairs.within.tensile_strength", false, 1, 1.5, 1, 2, 1.25, "crystals somewhat stronger than their boundaries"},
    {"pairs.within.fracture_energy", true, 1, 30, 1, 100, 8, "crystals tougher than their boundaries"}};

/// The box of a ratio: a key of [ratios], or a factor within crystals. It begins with what the material has itself; where that is
/// outside of the box, or the key has none, from half to twice that. Other keys have no bounds.
Parameter ratio_box(const Basis& basis, const std::string& key) {
    const Material& rock = basis.rock;
    std::optional<double> own;
    bool is_factor = false;
    for (const ContactParameter& row : all_contact_parameters()) {
        const bool is_energy = row.value == &ContactParameters::fracture_energy;
        if (key == "ratios." + (is_energy ? "process_zone" : row.key())) own = rock.ratios.*row.given;
        if (key != "pairs.within." + row.key()) continue;
        is_factor = true;
        own = rock.fabric.within.*row.given;
    }
    for (Parameter p : ratio_boxes) {
        if (p.key != key || (own && !(*own >= p.low && *own <= p.high))) continue;
        p.first = own.value_or(p.first);
        return p;
    }
    if (!own && !is_factor) return {"", true, NAN, NAN, NAN, NAN, NAN};
    const double value = own.value_or(1);
    return {"", true, 0.5 * value, 2 * value, 0.1 * value, 10 * value, value, "the material's own"};
}

/// A box whose first guess is what [ratios] of the material make of its laboratory: as wide about it as the default is about its
/// own, or half to twice it.
void begin_at_ratio(Parameter& p, const Material& rock) {
    const GivenContact given = given_contact(rock, PlaneCondition::strain, std::nullopt);
    for (const ContactParameter& row : all_contact_parameters()) {
        const bool follows = rock.ratios.*row.given && !(rock.contact.*row.given) && given.*row.given;
        if (p.key != "contact." + row.key() || !follows) continue;
        if (std::isnan(p.first)) p = {p.key, true, 0.5, 2, 0.1, 10, 1};
        const double factor = *(given.*row.given) / p.first;
        for (double* value : {&p.low, &p.high, &p.least, &p.most, &p.first}) *value *= factor;
        p.source = "of [ratios]";
    }
}

/// A row of [parameters] on top of its default box.
void set_parameter(Parameter& p, TomlTable row) {
    const Quantity quantity = material_quantity(p.key);
    if (row.has("first") || row.has("low") || row.has("high")) p.source = "given";
    row.given("first", quantity, p.first);
    // A bound of what is no ratio may be a part of the first guess; one that is given is a limit too.
    const auto bound = [&](const char* key, double& value, double& limit) {
        const bool is_part = row.shown(key).ends_with("%") && quantity.dimension != Dimension::one;
        row.given(key, is_part ? part_of_first : quantity, value);
        if (is_part) value *= p.first;
        if (row.has(key)) limit = value;
    };
    bound("low", p.low, p.least);
    bound("high", p.high, p.most);
    if (row.is_word("scale", "log") || row.is_word("scale", "linear")) {
        p.logarithmic = row.shown("scale") == "log";
    } else if (row.has("scale")) {
        row.refuse("scale", row.shown("scale") + " is neither log nor linear");
    }
    row.refuse_others();
}

void require_sound(Parameter& p, const std::string& where) {
    if (std::isnan(p.low) || std::isnan(p.high)) {
        throw InputError(fmt::format("{}: {} has no default bounds for this rock; give low and high", where, p.key));
    }
    if (!(p.low < p.high) || (p.logarithmic && !(p.low > 0))) {
        throw InputError(
            fmt::format("{}: {}: low must be below high{}", where, p.key, p.logarithmic ? " and above 0 (scale = \"log\")" : ""));
    }
    p.least = std::min(p.least, p.low);
    p.most = std::max(p.most, p.high);
    if (!(p.first >= p.low && p.first <= p.high)) p.first = p.value(0);
}

/// Of a value of each parameter.
DesignPoint coordinates_of(const std::vector<Parameter>& parameters, double Parameter::*value) {
    return DesignPoint::NullaryExpr(static_cast<Eigen::Index>(parameters.size()), [&](Eigen::Index k) {
        const Parameter& p = parameters[static_cast<std::size_t>(k)];
        return p.coordinate(p.*value);
    });
}

}  // namespace

Box box_between(const DesignPoint& low, const DesignPoint& high) { return {0.5 * (low + high), 0.5 * (high - low)}; }

Box hull(const Box& a, const Box& b) {
    return box_between((a.centre - a.half).cwiseMin(b.centre - b.half), (a.centre + a.half).cwiseMax(b.centre + b.half));
}

Box Box::about(const DesignPoint& at, double times, const Box& limits) const {
    const DesignPoint width = (times * half).cwiseMin(limits.half);
    const Box of_centres{limits.centre, limits.half - width};
    return {of_centres.nearest(at), width};
}

std::vector<DesignPoint> sobol_points(const Box& box, std::size_t first, std::size_t n) {
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(box.size())), &gsl_qrng_free);
    std::vector<DesignPoint> points;
    for (std::size_t i = 0; i < first + n; ++i) {
        DesignPoint share(box.size());
        gsl_qrng_get(sequence.get(), share.data());
        if (i >= first) points.emplace_back(box.centre + box.half.cwiseProduct(2 * share - DesignPoint::Ones(box.size())));
    }
    return points;
}

double Parameter::coordinate(double value) const {
    if (logarithmic) return std::log(value / low) / std::log(high / low) * 2 - 1;
    return (value - low) / (high - low) * 2 - 1;
}

double Parameter::value(double coordinate) const {
    const double share = (coordinate + 1) / 2;
    return logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
}

double Parameter::coordinate_by_log(double value) const {
    return logarithmic ? 2 / std::log(high / low) : 2 * value / (high - low);
}

std::vector<Parameter> parameters_of(const Material& rock, const TomlFile& file, double edge) {
    const Basis basis = basis_of(rock, edge);
    const auto usual = [&](const std::string& key) {
        Parameter p = ratio_box(basis, key);
        if (const DefaultBox* const box = default_box(basis, key)) p = box->of(basis);
        p.key = key;
        if (key == contrast) p.first = rock.fabric.contrast;
        begin_at_ratio(p, rock);
        return p;
    };
    std::vector<Parameter> parameters;
    auto table = TomlTable(file).table("parameters");
    for (const TomlTable& row : table ? table->tables() : std::vector<TomlTable>{}) {
        try {
            static_cast<void>(material_quantity(row.name()));
        } catch (const UsageError& error) {
            throw InputError(fmt::format("{}: {}", row.where(), error.what()));
        }
        parameters.push_back(usual(row.name()));
        set_parameter(parameters.back(), row);
        require_sound(parameters.back(), row.where());
    }
    if (parameters.empty()) {
        for (const DefaultBox& box : default_boxes) {
            if (!box.is_free || default_box(basis, box.key) != &box) continue;
            // Crystals keep the ratio by which the material gives the cohesion: as parts of tc it is known before tc is.
            const bool by_ratio = basis.crystals && box.reference == ucs && rock.ratios.cohesion && !rock.contact.cohesion;
            parameters.push_back(usual(by_ratio ? "ratios.cohesion" : box.key));
            require_sound(parameters.back(), file.file);
        }
    }
    return parameters;
}

Box limits_of(const std::vector<Parameter>& parameters) {
    return box_between(coordinates_of(parameters, &Parameter::least), coordinates_of(parameters, &Parameter::most));
}

DesignPoint first_guess(const std::vector<Parameter>& parameters) { return coordinates_of(parameters, &Parameter::first); }

Point point_at(const std::vector<Parameter>& parameters, const DesignPoint& at) {
    Point point;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        point.emplace_back(parameters[k].key, parameters[k].value(at(static_cast<Eigen::Index>(k))));
    }
    return point;
}

DisplayUnit display_unit(const std::string& key) {
    const Quantity quantity = material_quantity(key);
    switch (quantity.dimension) {
        case Dimension::stress:
            return quantity.name == quantity::young_modulus.name ? DisplayUnit{"GPa", 1e9} : DisplayUnit{"MPa", 1e6};
        case Dimension::angle: return {"deg", degree};
        case Dimension::one: return {"", 1};
        default: return {si_unit(quantity.dimension).data(), 1};
    }
}

std::string value_text(const std::string& key, double value, const char* between) {
    const DisplayUnit unit = display_unit(key);
    return fmt::format("{:.6g}{}{}", value / unit.si, unit.symbol[0] == '\0' ? "" : between, unit.symbol);
}

double in_unit(const std::string& key, double value) { return value / display_unit(key).si; }

std::string column_of(const std::string& key) {
    const std::string unit = display_unit(key).symbol;
    return key + (unit.empty() ? "" : "_" + unit);
}

std::vector<MaterialSetting> settings_of(const Point& point) {
    std::vector<MaterialSetting> settings;
    for (const auto& [key, value] : point) settings.emplace_back(key, value_text(key, value));
    return settings;
}

std::string label_of(const Point& point) {
    std::string text;
    for (const auto& [key, value] : point) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, value_text(key, value, " "));
    }
    return text;
}

}  // namespace graincrack::calibrate
