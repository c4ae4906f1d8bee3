// How fast the platens may move: as fast as the run's own measures say that it stays quasi-static.
//
// Three measures are kept below a tolerance T, each dimensionless:
//
//   inertia            √(12 K/U) of kinetic over stored energy. In a bar between platens that approach at a speed v each, it is
//                      2 v/(c ε), what the load rises by, relative to itself, while a wave runs through (K = m v²/6,
//                      U = ½ E ε² V, c = √(E/ρ))
//   unbalanced ratio   Σ|unbalanced force| / Σ|element force|
//   force difference   of the platens over their mean
//
// Kinetic energy is that of the masses as they are: what mass scaling adds to nodes that platens hold is no inertia of the
// load's. Where no damage is near, a load that rises fast does no harm, and for the first two up to 0.1 counts. What is
// near is seen before it cracks, from the share of contact points that would fail if their jumps grew by a quarter. Damage under
// way shows in the measures.
//
// Pure: measures in, speed out. The logarithm of the speed follows what the measures allow within some wave transits, at a rate
// that is limited, so that it changes smoothly.
#pragma once

namespace graincrack {

/// What a run measures at the end of a batch.
struct RateMeasures {
    double strain = 0;            ///< platen travel over height since axial loading began, in the sense of the test
    double kinetic_energy = 0;    ///< of the masses as they are, J
    double stored_energy = 0;     ///< J
    double unbalanced_ratio = 0;  ///< as in the history
    double force_difference = 0;  ///< of the platens, over their mean
    double endangered = 0;        ///< share of contact points that would fail if their jumps grew by a quarter, 0 to 1
};

/// Rise of the load over itself in a wave transit up to which it is quasi-static while there is damage.
/// \see share/doc/equilibrium.md
inline constexpr double default_rate_tolerance = 1.5e-3;

/// A specimen as the control sees it: a bar between platens.
struct RateScales {
    double height = 0;        ///< m
    double transit_time = 0;  ///< of a bar wave through it, s
    double least_strain = 0;  ///< below it there is no load to speak of yet: a speed must begin somewhere
    double least_energy = 0;  ///< stored then, J
};

class RateControl {
public:
    RateControl(double tolerance, const RateScales& scales) : tolerance_(tolerance), scales_(scales) {}
    /// Speed of each platen at the end of the next `duration` seconds, m/s.
    double next(const RateMeasures& measures, double duration);
    /// The slowest the platens ever go at a strain, m/s: half of what the tolerance means there without damage.
    /// \param allowed what counts of the tolerance
    [[nodiscard]] double least_speed(double strain, double allowed) const;
    /// What the tolerance counts with a share of endangered contact points.
    [[nodiscard]] double allowed(double endangered) const;
    /// The fastest the platens ever go at a strain, m/s.
    [[nodiscard]] double most_speed(double strain) const;
    /// Calls `visit(name, member)` with all that changes: a test that goes on needs it.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("rate.endangered", self.endangered_);
        visit("rate.inertia", self.inertia_);
        visit("rate.unbalanced_ratio", self.unbalanced_ratio_);
        visit("rate.force_difference", self.force_difference_);
        visit("rate.speed", self.speed_);
    }

private:
    double tolerance_;
    RateScales scales_;
    double endangered_ = 0;  ///< the largest share so far: what was once near damage is not hurried any more
    double inertia_ = 0;     ///< this and the next two: means over about a transit
    double unbalanced_ratio_ = 0;
    double force_difference_ = 0;
    double speed_ = 0;
};

}  // namespace graincrack
