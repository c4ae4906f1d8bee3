// A contact point on a prescribed path of opening and sliding, with the work done on it and the dissipation that the law reports.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "share/rock/material.hpp"
#include "solver/law/contact_law.hpp"

namespace graincrack {

/// Recoverable energy per area of a contact point in its present motion, J/m².
inline double stored_energy(const ContactLaw& law, const ContactHistory& h) {
    return contact_law::with_law(law.variant, [&](auto kind) { return decltype(kind)::stored_energy(law, h); });
}
/// Fraction of the peak of its cohesive traction that a contact point can still bear.
inline double remaining_cohesion(const ContactLaw& law, const ContactHistory& h) {
    return contact_law::with_law(law.variant, [&](auto kind) { return contact_law::remaining_cohesion<decltype(kind)>(law, h); });
}

/// Damage D of a contact point, 0 to 1.
inline double damage(const ContactLaw& law, const ContactHistory& h) {
    return contact_law::with_law(law.variant, [&](auto kind) { return contact_law::damage<decltype(kind)>(law, h); });
}

}  // namespace graincrack

namespace graincrack::test {

/// Every contact law.
inline std::vector<ContactLaw> all_laws(const ContactParameters& contact) {
    std::vector<ContactLaw> laws;
    for (const LawDescription& law : all_contact_laws()) laws.push_back(make_contact_law(contact, law.variant));
    return laws;
}

/// Every law, and with bridges those that may have them: to the end of the paths.
inline std::vector<ContactLaw> every_law(const ContactParameters& c) {
    std::vector<ContactLaw> laws = all_laws(c);
    ContactParameters bridged = c;
    bridged.bridging_strength = 0.45 * c.tensile_strength;
    bridged.bridging_energy = 0.3 * bridged.bridging_strength * c.ultimate_opening;
    for (const ContactLaw& law : all_laws(bridged)) {
        if (law.bridge > 0) laws.push_back(law);
    }
    return laws;
}

class ContactWalk {
public:
    explicit ContactWalk(const ContactLaw& law, const ContactHistory& start = {}) : law_(law), history_(start) {}

    /// One update. The work per area is that of the mean of the tractions before and after.
    ContactTraction to(const ContactMotion& motion) {
        const ContactMotion from = history_.motion;
        const ContactResponse r = update_contact(law_, motion, history_);
        work_ += 0.5 * ((traction_.normal + r.traction.normal) * (motion.opening - from.opening) +
                        (traction_.shear + r.traction.shear) * (motion.sliding - from.sliding));
        fracture_ += r.dissipation.fracture;
        friction_ += r.dissipation.friction;
        non_conservative_ += r.dissipation.non_conservative_work;
        min_fracture_ = std::min(min_fracture_, r.dissipation.fracture);
        min_friction_ = std::min(min_friction_, r.dissipation.friction);
        largest_shear_ = std::max(largest_shear_, std::abs(r.traction.shear));
        healed_ = healed_ || damage(law_, r.history) < damage(law_, history_) || (history_.failed() && !r.history.failed()) ||
                  (history_.separated && !r.history.separated);
        history_ = r.history;
        traction_ = r.traction;
        return traction_;
    }
    /// A straight path in equal steps.
    ContactTraction go(const ContactMotion& end, int steps) {
        const ContactMotion from = history_.motion;
        for (int i = 1; i < steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            to({from.opening + share * (end.opening - from.opening), from.sliding + share * (end.sliding - from.sliding)});
        }
        return to(end);
    }

    [[nodiscard]] const ContactHistory& history() const { return history_; }
    [[nodiscard]] const ContactTraction& traction() const { return traction_; }
    [[nodiscard]] double work() const { return work_; }
    [[nodiscard]] double fracture() const { return fracture_; }
    [[nodiscard]] double friction() const { return friction_; }
    [[nodiscard]] double non_conservative() const { return non_conservative_; }
    [[nodiscard]] double stored() const { return stored_energy(law_, history_); }
    /// work − stored energy − dissipation − non-conservative work
    [[nodiscard]] double balance() const { return work_ - stored() - fracture_ - friction_ - non_conservative_; }
    [[nodiscard]] double min_fracture() const { return min_fracture_; }  ///< smallest of any update
    [[nodiscard]] double min_friction() const { return min_friction_; }
    [[nodiscard]] double largest_shear() const { return largest_shear_; }
    [[nodiscard]] bool healed() const { return healed_; }  ///< damage decreased or a failed point became intact

private:
    ContactLaw law_;
    ContactHistory history_;
    ContactTraction traction_;
    double work_ = 0, fracture_ = 0, friction_ = 0, non_conservative_ = 0;
    double min_fracture_ = 0, min_friction_ = 0, largest_shear_ = 0;
    bool healed_ = false;
};

}  // namespace graincrack::test
