// Scatters strengths: a Weibull factor for every grain boundary.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Requested scatter of the strength of grain boundaries.
struct StrengthRequest {
    std::optional<double> modulus;      ///< Weibull modulus m, at least 1; missing: no scatter
    std::optional<double> correlation;  ///< distance at which the autocorrelation is 1/e, m; missing: uncorrelated
    std::optional<std::uint64_t> seed;  ///< missing: that of the specimen
};

/// Checks a request. \throws UsageError naming the option if a length or a seed has no modulus
void check(const StrengthRequest& request);

/// Returns the Weibull factor of mean 1, s = (−ln q)^(1/m)/Γ(1 + 1/m), exceeded by the fraction q. \param log_q ln q, below 0
double weibull_factor(double log_q, double modulus);

/// A Gaussian field of the plane with mean 0, variance 1 and the autocorrelation exp(−distance/length), as a sum of cosine modes.
/// The averages are over seeds, or over regions large against the length.
class GaussianField {
public:
    /// \param length m
    GaussianField(double length, std::uint64_t seed);
    double operator()(Point at) const;

private:
    struct Mode {
        Point wave_vector;  ///< rad/m
        double phase;       ///< rad
    };
    std::vector<Mode> modes_;
};

/// Sets the strength factor of every contact. Contacts of one grain boundary have the same factor.
///
/// An uncorrelated factor follows from the seed and the two crystals. A correlated one follows from the Gaussian field z at the
/// middle of the grain boundary, q = 1 − Φ(z). The correlation length is that of z; that of the factors is up to 3 % shorter for
/// m ≥ 2, 11 % for m = 1. The mean over one specimen is not scaled to 1: unless the length is small against the specimen,
/// specimens differ in mean strength.
///
/// \param crystal_of_grain the crystal of every grain
/// \param turn angle by which the specimen was rotated from its field, rad
void assign_strength_factors(Specimen& specimen, std::span<const int> crystal_of_grain, double turn,
                             const StrengthRequest& request);

}  // namespace graincrack::mesher
