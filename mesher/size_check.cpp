#include "mesher/size_check.hpp"

#include <fmt/format.h>

#include "share/base/units.hpp"
#include "share/rock/fracture_process_zone.hpp"

namespace graincrack::mesher {

namespace {

std::string millimetres(double value) { return format_number(in_unit(value, Dimension::length, "mm"), 3) + " mm"; }

}  // namespace

SizeBounds size_bounds(const Material& material) {
    const Rock& rock = material.rock;
    constexpr PlaneCondition plane = PlaneCondition::stress;
    const double tc = contact_parameters(material, plane, std::nullopt).tensile_strength;
    SizeBounds bounds;
    bounds.lower = fpz::min_grain_size(rock);
    bounds.lower_shear = fpz::min_grain_size_shear(rock);
    bounds.upper = fpz::max_grain_size(rock);
    bounds.contact_zone_mixed = fpz::contact_zone_length(rock, plane, fpz::mixed_mode_fracture_energy(rock, plane), tc);
    bounds.contact_zone_mode_i = fpz::contact_zone_length(rock, plane, fpz::mode_i_fracture_energy(rock, plane), tc);
    return bounds;
}

std::vector<std::string> describe_size_check(const Material& material, double mean_edge) {
    const SizeBounds bounds = size_bounds(material);
    const auto above = [&](double bound) { return mean_edge > bound ? "kept" : "not kept: grains are too small"; };
    const auto below = [&](double bound) { return mean_edge < bound ? "kept" : "not kept: grains are too large"; };
    const auto zone = [&](const char* kind, double length) {
        return fmt::format("  contact zone (9 pi/32) E' Gf/tc^2, Gf {:<16} {:>9}   {:.2g} mean edges", kind, millimetres(length),
                           length / mean_edge);
    };
    return {
        fmt::format("grain size for {}: mean edge {}", material.name, millimetres(mean_edge)),
        fmt::format("  lower bound 10 w_I = 40 K_IC^2/(E sigma_t), Eqs 15, 17    {:>9}   {}", millimetres(bounds.lower),
                    above(bounds.lower)),
        fmt::format("  lower bound 10 w_II (the same with K_IIC)                 {:>9}   {}", millimetres(bounds.lower_shear),
                    above(bounds.lower_shear)),
        fmt::format("  upper bound l/3, l = (9 pi/32) (K_IC/sigma_t)^2, Eqs 15-17 {:>8}   {}", millimetres(bounds.upper),
                    below(bounds.upper)),
        zone("mixed", bounds.contact_zone_mixed),
        zone("mode-i", bounds.contact_zone_mode_i),
    };
}

}  // namespace graincrack::mesher
