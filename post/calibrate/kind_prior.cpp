#include "post/calibrate/kind_prior.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace graincrack::calibrate {

namespace {

/// Smallest diameter of half-discs over the grain size for which K_IC of the rock type holds; 20 in its design. Chosen by trial.
constexpr double least_half_disc = 14;
constexpr double most_half_disc = 28;

/// Parameters that are coordinates of the response surface.
constexpr std::pair<const char*, double KindCoordinates::*> bounded[] = {
    {"ratios.cohesion", &KindCoordinates::cohesion},
    {"contact.friction_angle", &KindCoordinates::friction_angle},
    {"contact.residual_friction_angle", &KindCoordinates::residual_friction_angle},
    {"ratios.process_zone", &KindCoordinates::process_zone},
    {"ratios.mode_ii_fracture_energy", &KindCoordinates::mode_ii_fracture_energy},
    {"ratios.bridging_strength", &KindCoordinates::bridging_strength}};

/// Contact values that determine the coordinates.
constexpr ContactValue values_known[] = {&ContactParameters::tensile_strength,  &ContactParameters::cohesion,
                                         &ContactParameters::friction_angle,    &ContactParameters::residual_friction_angle,
                                         &ContactParameters::fracture_energy,   &ContactParameters::mode_ii_fracture_energy,
                                         &ContactParameters::bridging_strength, &ContactParameters::bridging_energy};

/// The value of a key of [contact] or [ratios] in a material; null for a key without influence on the coordinates.
std::optional<double>* place_of(Material& material, const std::string& key) {
    for (const ContactParameter& row : all_contact_parameters()) {
        if (std::find(std::begin(values_known), std::end(values_known), row.value) == std::end(values_known)) continue;
        const bool is_energy = row.value == &ContactParameters::fracture_energy;
        if (key == "contact." + row.key()) return &(material.contact.*row.given);
        if (key == "ratios." + (is_energy ? "process_zone" : row.key())) return &(material.ratios.*row.given);
    }
    return nullptr;
}

}  // namespace

/// The rock with the values of a design point.
struct KindPrior::Changed {
    Material material;
    std::vector<Parameter> parameters;
    std::vector<std::optional<double>*> places;  ///< [parameters] their values in the rock

    [[nodiscard]] KindCoordinates at(const DesignPoint& point) const {
        auto coordinate = point.begin();
        for (std::size_t k = 0; k < places.size(); ++k) *places[k] = parameters[k].value(*coordinate++);
        return kind_coordinates(material);
    }
};

KindPrior::KindPrior(std::shared_ptr<const KindSurface> kind, const Material& rock, const std::vector<Parameter>& parameters,
                     const Study& study)
    : kind_(std::move(kind)),
      study_(study),
      changed_(std::make_shared<Changed>(Changed{rock, parameters, {}})),
      limits_(limits_of(parameters)) {
    if (!kind_) return;
    DesignPoint low = limits_.centre - limits_.half;
    DesignPoint high = limits_.centre + limits_.half;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const Parameter& p = parameters[k];
        changed_->places.push_back(place_of(changed_->material, p.key));
        if (changed_->places.back() == nullptr && unknown_.empty()) unknown_ = p.key;
        for (const auto& [key, coordinate] : bounded) {
            if (p.key != key) continue;
            const auto i = static_cast<Eigen::Index>(k);
            if (kind_->least().*coordinate > p.least) low(i) = p.coordinate(kind_->least().*coordinate);
            if (kind_->most().*coordinate < p.most) high(i) = p.coordinate(kind_->most().*coordinate);
            if (!(low(i) < high(i)) && unknown_.empty()) unknown_ = p.key;
        }
    }
    box_ = box_between(low, high);
    if (unknown_.empty()) first_ = changed_->at(box_.nearest(first_guess(parameters)));
}

const KindModel* KindPrior::model(const Target& target) const {
    if (!kind_ || !unknown_.empty()) return nullptr;
    if (target.property.loading == Loading::bending) {
        const ToughnessTest bend = study_.specimens.bend();
        const double size = bend.size / changed_->material.grains.grain_size.value_or(NAN);
        if (bend.method != "half-disc" || !(size >= least_half_disc && size <= most_half_disc)) return nullptr;
    }
    if (!kind_->holds(first_, target.confining_pressure)) return nullptr;
    return kind_->model(target.property, target.confining_pressure);
}

std::string KindPrior::lacks(const std::vector<Target>& targets) const {
    if (!kind_) return "no kind has this fabric";
    if (!unknown_.empty()) return fmt::format("the kind {} does not know {}", kind_->kind(), unknown_);
    if (const std::string beyond = kind_->beyond(first_); !beyond.empty()) {
        return fmt::format("the kind {}: {}", kind_->kind(), beyond);
    }
    for (const Target& target : targets) {
        if (target.use != Use::fit || target.is_elastic()) continue;
        if (model(target) == nullptr) {
            return fmt::format("the kind {} does not know the {} of such specimens", kind_->kind(), target.symbol());
        }
    }
    return "";
}

std::optional<LocalSurface> KindPrior::surface(const Target& target) const {
    const KindModel* const found = model(target);
    if (found == nullptr) return std::nullopt;
    auto of_rock = static_cast<const LinearModel&>(*found);
    of_rock.inverse(0, 0) += found->rock_variance / found->variance;  // of the constant
    of_rock.freedom = found->freedom_of_mean(kind_->factors(first_, target.confining_pressure));
    return LocalSurface(
        [kind = kind_, changed = changed_, target](const DesignPoint& point) {
            const KindCoordinates at = changed->at(point);
            return Located{kind->factors(at, target.confining_pressure), KindSurface::log_unit(target.property, at)};
        },
        std::move(of_rock), true);
}

bool KindPrior::ends_at(const DesignPoint& point) const {
    const DesignPoint here = box_.local(point);
    const DesignPoint beyond = limits_.local(point);
    return (here.array().abs() > 0.999 && beyond.array().abs() < 0.999).any();
}

}  // namespace graincrack::calibrate
