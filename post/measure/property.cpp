#include "post/measure/property.hpp"

#include <algorithm>

namespace graincrack {

namespace {

template <double ElasticPair::*member>
std::optional<double> modulus_of(const MeasuredRun& run) {
    return run.moduli ? std::optional(run.moduli->chord.*member) : std::nullopt;
}

template <auto stress>
std::optional<double> threshold_of(const MeasuredRun& run) {
    return run.threshold(stress);
}

template <StrengthKind kind>
std::optional<double> strength_of_kind(const MeasuredRun& run) {
    return run.strength.reported(kind);
}

std::optional<double> drop_of(const MeasuredRun& run) {
    return run.strength.first_peak ? run.strength.first_peak->drop : std::nullopt;
}

std::optional<double> tensile_fraction_of(const MeasuredRun& run) {
    const double all = run.by_sign_at_peak.tensile + run.by_sign_at_peak.shear;
    return all > 0 ? std::optional(run.by_sign_at_peak.tensile / all) : std::nullopt;
}

}  // namespace

std::optional<double> strength_of(const MeasuredRun& run) { return run.strength.reported(); }

const std::vector<Property>& all_properties() {
    using enum PressureOf;
    using L = Loading;
    using Run = MeasuredRun;
    using All = AllThresholds;
    constexpr double MPa = 1e6;
    constexpr double never = 1;
    constexpr double behind_first_peak = 0.1;  // a first peak is one that the stress falls 5 % of σ1 − σ3 behind
    constexpr double usual_drop = 0.3;         // the solver's own
    constexpr Quantity stress{"stress", Dimension::stress, 0, 1e12, "stress", true};
    constexpr Quantity part{"part", Dimension::one, 0, 1, "part", true};
    // clang-format off
    static const std::vector<Property> rows{
        {"young_modulus", "E", "Young's modulus E", "young_modulus", L::compression, none, quantity::young_modulus, "GPa", 1e9,
         0.02, false, behind_first_peak, false, true, "young_modulus_GPa", 1e9, "", modulus_of<&ElasticPair::young_modulus>},
        {"poisson_ratio", "ν", "Poisson's ratio ν", "poisson_ratio", L::compression, none, quantity::poisson_ratio, "", 1,
         0.015, true, behind_first_peak, false, true, "poisson_ratio", 1, "", modulus_of<&ElasticPair::poisson_ratio>},
        {"brazilian", "Brazilian strength", "Brazilian tensile strength", "tensile_strength", L::splitting, none, stress, "MPa", MPa,
         0.05, false, usual_drop, false, true, "tensile_strength_MPa", MPa, "", strength_of},
        {"direct_tension", "direct tensile strength", "direct tensile strength", "direct_tensile_strength", L::tension, none, stress,
         "MPa", MPa, 0.05, false, usual_drop, false, true, "tensile_strength_MPa", MPa, "", strength_of},
        {"toughness", "K_IC", "fracture toughness K_IC", "mode_i_toughness", L::bending, none, quantity::mode_i_toughness, "MPa√m",
         MPa, 0.1, false, usual_drop, false, true, "mode_i_toughness_MPa.m^0.5", MPa, "",
         [](const Run& run) { return run.mode_i_toughness; }},
        {"uniaxial", "UCS", "UCS", "compressive_strength", L::compression, none, stress, "MPa", MPa,
         0.05, false, behind_first_peak, true, true, "first_peak_MPa", MPa, "", strength_of},
        {"first_peak", "first peak", "σ1", "confined_strength", L::compression, name, stress, "MPa", MPa,
         0.08, false, behind_first_peak, true, false, "first_peak_MPa", MPa, "", strength_of},
        {"largest", "largest stress", "largest stress", "largest", L::compression, either, stress, "MPa", MPa,
         0.05, false, never, false, false, "peak_compressive_stress_MPa", MPa, "", strength_of_kind<StrengthKind::largest>},
        {"residual", "residual strength", "residual strength", "residual", L::compression, either, stress, "MPa", MPa,
         0.1, false, never, false, false, "residual_MPa", MPa, "", strength_of_kind<StrengthKind::residual>},
        {"drop", "drop behind the first peak", "drop behind the first peak", "drop", L::compression, either, part, "%", 0.01,
         0.2, false, never, false, false, "drop_percent", 0.01, "", drop_of},
        // Before crack_initiation, with which its name begins.
        {"crack_initiation_count", "crack initiation by count of cracks", "CI by count of cracks", "crack_initiation_count",
         L::compression, either, stress, "MPa", MPa, 0.1, false, behind_first_peak, false, false, "crack_initiation_count_MPa", MPa,
         "", threshold_of<&All::initiation_by_count>},
        {"crack_initiation", "crack initiation", "crack initiation CI", "crack_initiation", L::compression, either, stress, "MPa",
         MPa, 0.1, false, behind_first_peak, false, true, "crack_initiation_MPa", MPa, "", threshold_of<&All::initiation>},
        {"crack_damage", "crack damage", "crack damage CD", "crack_damage", L::compression, either, stress, "MPa", MPa,
         0.1, false, behind_first_peak, false, true, "crack_damage_MPa", MPa, "", threshold_of<&All::damage>},
        {"tensile_share", "tensile share of cracks", "tensile share of cracks", "tensile_share", L::compression, either, part, "", 1,
         0.2, false, behind_first_peak, false, false, "tensile_cracks_by_sign", 1, "shear_cracks_by_sign", tensile_fraction_of},
        {"strain_at_peak", "strain at the peak", "strain at the peak", "strain_at_peak", L::compression, either, part, "%", 0.01,
         0.1, false, behind_first_peak, false, false, "strain_at_peak", 1, "",
         [](const Run& run) { return run.strength.strength ? std::optional(run.strength.peak.strain) : std::nullopt; }},
    };
    // clang-format on
    return rows;
}

std::size_t order_of(const Property& property) {
    return static_cast<std::size_t>(std::ranges::find(all_properties(), property.name, &Property::name) -
                                    all_properties().begin());
}

const Property& property_named(const std::string& name) { return *std::ranges::find(all_properties(), name, &Property::name); }

}  // namespace graincrack
