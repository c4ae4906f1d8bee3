// The four laboratory tests as data: platens, membrane, and how both move in time.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "share/material.hpp"
#include "share/specimen.hpp"
#include "solver/boundary.hpp"

namespace graincrack {

enum class TestKind : std::uint8_t { uniaxial, triaxial, brazilian, tension };
constexpr std::string_view name_of(TestKind test) {
    switch (test) {
        case TestKind::uniaxial: return "uniaxial";
        case TestKind::triaxial: return "triaxial";
        case TestKind::brazilian: return "brazilian";
        case TestKind::tension: return "tension";
    }
    return "?";
}

/// What a test asks of its loading.
struct LoadingRequest {
    TestKind test = TestKind::uniaxial;
    double platen_speed = 5e-3;     ///< of each platen, m/s
    double confining_pressure = 0;  ///< Pa
    double platen_friction = 0;     ///< rad
    double max_strain = 0.015;
};

/// Platens and membrane of a test. Platens have the contacts' stiffness per area; the caps of a tension test are glued on
/// and smooth, so that they do not hinder the lateral contraction.
Boundary make_test_boundary(const Assemblage& assemblage, const Specimen& specimen, const LoadingRequest& request,
                            const ContactParameters& contact);

/// What the loading needs to know of the specimen's answer.
struct LoadingFeedback {
    double time = 0;
    double axial_compression = 0;  ///< mean of the platens, Pa
    double unbalanced_ratio = 0;
};

/// Moves platens and pressure from batch to batch: isotropic stage first where there is a pressure, then the platens at
/// constant speed after a smooth start.
class Loading {
public:
    Loading(const LoadingRequest& request, const Specimen& specimen, const Rock& rock, PlaneCondition plane);
    /// Loading of the next `duration` seconds.
    /// \throws NumericalError if the isotropic stage does not settle
    BatchLoading next(const LoadingFeedback& feedback, double duration);
    [[nodiscard]] bool is_isotropic() const { return isotropic_; }
    [[nodiscard]] double isotropic_end_time() const { return isotropic_end_time_; }
    [[nodiscard]] double platen_speed() const { return speed_; }  ///< at the end of the last batch, approach positive, m/s

private:
    [[nodiscard]] double target_pressure(double time) const;
    double isotropic_speed(const LoadingFeedback& feedback, double duration) const;

    LoadingRequest request_;
    double height_;
    double transit_time_;          ///< of a bar wave through the specimen, s
    double young_modulus_;         ///< of the rock, Pa
    double isotropic_compliance_;  ///< axial strain per isotropic pressure, 1/Pa
    double ramp_time_ = 0;         ///< of the pressure, s
    bool isotropic_ = false;
    double isotropic_end_time_ = 0;
    double mean_compression_ = 0;  ///< over about a transit, Pa
    double start_time_ = 0;        ///< of the platens' run at constant speed, s
    double start_speed_ = 0;
    double speed_ = 0;
};

}  // namespace graincrack
