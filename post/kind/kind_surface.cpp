#include "post/kind/kind_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "share/base/error.hpp"
#include "share/base/shared_file.hpp"
#include "share/base/table_file.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"
#include "share/rock/material_edit.hpp"

namespace graincrack {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double floor_of_rocks = 0.03;  // standard deviation of ln
/// d ln CI/tc by d ln tc/(kt d), fitted to tests with CI at crack strains other than 1e-5 (share/studies/surface).
constexpr double initiation_exponent = -0.24;

/// A continuous factor: 0 at usual values of contacts without bridges, and about ±1 at the ends of the design. \param pressure
/// over tc; without a pressure its factor is 0, and no term has it
struct Factor {
    const char* name;
    double (*of)(const KindCoordinates& at, double pressure);
};
using At = KindCoordinates;
constexpr std::array<Factor, 8> continuous{{
    {"ln(cohesion/5)", [](const At& at, double /*pressure*/) { return std::log(at.cohesion / 5); }},
    {"(friction_angle_deg-44)/8", [](const At& at, double /*pressure*/) { return (at.friction_angle / degree - 44) / 8; }},
    {"(residual_friction_angle_deg-17)/8",
     [](const At& at, double /*pressure*/) { return (at.residual_friction_angle / degree - 17) / 8; }},
    {"ln(process_zone/1.16)", [](const At& at, double /*pressure*/) { return std::log(at.process_zone / 1.16); }},
    {"ln(mode_ii_fracture_energy/47)",
     [](const At& at, double /*pressure*/) { return std::log(at.mode_ii_fracture_energy / 47); }},
    {"bridging_strength", [](const At& at, double /*pressure*/) { return at.bridging_strength; }},
    {"bridging_strength*ln(bridging_energy/8)",
     [](const At& at, double /*pressure*/) {
         return at.bridging_strength > 0 ? at.bridging_strength * std::log(at.bridging_energy / 8) : 0;
     }},
    {"ln(confining_pressure/1.5)", [](const At& /*at*/, double pressure) { return pressure > 0 ? std::log(pressure / 1.5) : 0; }},
}};

/// A coordinate that a design bounds, with its name in words and the factor of shown values.
struct Bounded {
    const char* name;
    double KindCoordinates::*coordinate;
    double shown = 1;
};
constexpr std::array<Bounded, 7> bounded{{{"cohesion over tc", &At::cohesion},
                                          {"friction angle in degrees", &At::friction_angle, 1 / degree},
                                          {"residual friction angle in degrees", &At::residual_friction_angle, 1 / degree},
                                          {"process zone over grain size", &At::process_zone},
                                          {"G_II over G_I", &At::mode_ii_fracture_energy},
                                          {"bridging strength over tc", &At::bridging_strength},
                                          {"bridging energy over tc² d/E", &At::bridging_energy}}};

std::vector<double> factors_of(const KindCoordinates& at, double pressure, const std::string& kind,
                               const std::vector<std::string>& kinds) {
    std::vector<double> factors;
    for (const Factor& factor : continuous) factors.push_back(factor.of(at, pressure / at.tensile_strength));
    for (const std::string& each : kinds) factors.push_back(each == kind ? 1 : 0);
    return factors;
}

/// The constant and linear terms of the factors that vary, followed by products and squares of the continuous factors.
std::vector<SurfaceTerm> terms_of(const std::vector<std::vector<double>>& factors) {
    std::vector<SurfaceTerm> terms = quadratic_terms(factors.front().size());
    std::erase_if(terms, [&](const SurfaceTerm& term) {
        for (std::size_t k = 0; k < term.power.size(); ++k) {
            const auto is_first = [&](const std::vector<double>& row) { return row[k] == factors.front()[k]; };
            if (term.power[k] == 0) continue;
            if (k >= continuous.size() && term.degree() > 1) return true;
            if (std::ranges::all_of(factors, is_first)) return true;
        }
        return false;
    });
    return terms;
}

/// Fits a model with products and squares shrunk to 0. A selection of terms would have intervals that ignore the selection:
/// measured with forward selection by PRESS, intervals of 95 % hold 87 % of new specimens. \throws InputError if the values do
/// not determine the linear terms
KindModel fit_model(const std::string& property, const std::vector<std::vector<double>>& factors,
                    const std::vector<double>& logarithms, const std::vector<std::string>& specimens) {
    std::vector<SurfaceTerm> terms = terms_of(factors);
    const auto n_linear =
        static_cast<std::size_t>(std::ranges::count_if(terms, [](const SurfaceTerm& term) { return term.degree() < 2; }));
    if (auto fitted = LinearModel::fit_restricted(std::move(terms), n_linear, factors, logarithms, specimens)) {
        return {*std::move(fitted)};
    }
    throw InputError(
        fmt::format("surface of a kind: {} has {} values, which do not determine its {} linear terms; {} or more "
                    "at different ratios are needed",
                    property, logarithms.size(), n_linear, n_linear + 2));
}

/// A property that a surface does not vary: a number, a word, or neither if it is not given.
struct FixedTrait {
    std::optional<double> number;
    std::string word = {};
    static constexpr int digits = 4;  ///< significant digits of compared numbers
    [[nodiscard]] bool is_like(const FixedTrait& other) const {
        const auto near = [](double a, double b) { return rounded(a, digits) == rounded(b, digits); };
        return word == other.word && number.has_value() == other.number.has_value() && (!number || near(*number, *other.number));
    }
    /// \param key of a material file
    [[nodiscard]] std::string text(const std::string& key) const {
        if (number) return format_quantity(*number, material_quantity(key).dimension, digits);
        return word.empty() ? "not given" : word;
    }
};

/// The traits of a material by their keys in its file.
std::map<std::string, FixedTrait> fixed_traits(const Material& material) {
    const GivenContact& contact = material.contact;
    const auto open_shear = contact.open_shear_strength
                                ? std::optional(*contact.open_shear_strength / kind_coordinates(material).tensile_strength)
                                : material.ratios.open_shear_strength;
    const GrainFabric& grains = material.grains;
    std::map<std::string, FixedTrait> traits{
        {"contact.law", {{}, material.law}},
        {"contact.normal_stiffness", {contact.normal_stiffness}},
        {"contact.shear_stiffness", {contact.shear_stiffness}},
        {"contact.residual_tensile_strength", {contact.residual_tensile_strength.value_or(0)}},
        {"contact.residual_cohesion", {contact.residual_cohesion.value_or(0)}},
        {"ratios.open_shear_strength", {open_shear}},
        {"contact.wear_slip", {contact.wear_slip.value_or(0)}},
        {"pairs.within.bridging_strength", {1}},  // unless they are given
        {"pairs.within.bridging_energy", {1}},
        {"fabric.tessellation", {{}, grains.tessellation}},
        {"fabric.size_variation", {grains.size_variation}},
        {"fabric.elements_per_crystal", {grains.elements_per_crystal}},
        {"fabric.elongation", {grains.elongation.value_or(1)}},
        {"platen.friction_angle", {material.platen_friction_angle}}};
    for (const FabricValue& value : fabric_values(material.fabric)) {
        traits[value.table + "." + value.key] = {value.number, value.word};
    }
    return traits;
}

/// The differences of a material from a rock type, in words.
std::vector<std::string> differences_from(const RockKind& kind, std::map<std::string, FixedTrait> own) {
    const std::string file = materials().below("kinds/" + kind.name + ".toml").string();
    std::map<std::string, FixedTrait> its = fixed_traits(read_incomplete_material(file).material);
    for (const auto& [key, value] : own) its.try_emplace(key);
    std::vector<std::string> found;
    for (const auto& [key, value] : its) {
        if (own[key].is_like(value)) continue;
        found.push_back(fmt::format("its {} is {}, that of {} {}", key, own[key].text(key), kind.name, value.text(key)));
    }
    return found;
}

}  // namespace

KindCoordinates kind_coordinates(const Material& material) {
    const ContactParameters contact = contact_parameters(material, PlaneCondition::strain, std::nullopt);
    const double tc = contact.tensile_strength;
    const double size = material.grains.grain_size.value_or(0);
    const double unit_of_energy = tc * tc * size / material.rock.young_modulus;
    return {.tensile_strength = tc,
            .grain_size = size,
            .cohesion = contact.cohesion / tc,
            .friction_angle = contact.friction_angle,
            .residual_friction_angle = contact.residual_friction_angle,
            .process_zone = contact.fracture_energy / unit_of_energy,
            .mode_ii_fracture_energy = contact.mode_ii_fracture_energy / contact.fracture_energy,
            .bridging_strength = contact.bridging_strength / tc,
            .bridging_energy = contact.bridging_energy / unit_of_energy,
            .contact_strain = tc / (contact.normal_stiffness * size)};
}

double KindPrediction::specimen_at(double deviations) const { return value * std::exp(deviations * specimen_deviation); }

std::vector<KindRow> read_kind_rows(const std::string& file) {
    const TableFile table(file);
    std::vector<KindRow> rows;
    for (std::size_t i = 0; i < table.n_rows(); ++i) {
        const auto number = [&](const char* column, bool may_be_zero = false) {
            const double value = table.number(i, column);
            if (std::isfinite(value) && (may_be_zero ? value >= 0 : value > 0)) return value;
            throw InputError(fmt::format("{}: {} is \"{}\"; a number {} is needed", table.where(i), column, table.text(i, column),
                                         may_be_zero ? "from 0 on" : "above 0"));
        };
        constexpr bool or_zero = true;
        KindRow row;
        row.kind = table.text(i, "kind");
        row.point = table.text(i, "point");
        row.is_rock = number("rock", or_zero) > 0;
        row.at = {.tensile_strength = 1,
                  .grain_size = 1,
                  .cohesion = number("cohesion"),
                  .friction_angle = number("friction_angle_deg") * degree,
                  .residual_friction_angle = number("residual_friction_angle_deg") * degree,
                  .process_zone = number("process_zone"),
                  .mode_ii_fracture_energy = number("mode_ii_fracture_energy"),
                  .bridging_strength = number("bridging_strength", or_zero),
                  .bridging_energy = number("bridging_energy", or_zero)};
        if (table.has("contact_strain")) row.at.contact_strain = number("contact_strain");
        row.confining_pressure = number("confining_pressure", or_zero);
        row.property = table.text(i, "property");
        row.value = number("value");
        row.specimens = number("specimens");
        const auto require = [&](bool is_sound, const char* needed) {
            if (!is_sound) throw InputError(fmt::format("{}: {}", table.where(i), needed));
        };
        const auto& all = all_properties();
        const auto found = std::ranges::find_if(all, [&](const Property& each) { return each.name == row.property; });
        require(!row.kind.empty(), "kind is empty; a kind of rock is needed");
        require(found != all.end(), "property is unknown; the name of a target is needed, such as uniaxial");
        require((found->pressure == PressureOf::name) == (row.confining_pressure > 0),
                "confining_pressure does not fit property; first_peak has one above 0, others have 0");
        require((row.at.bridging_strength > 0) == (row.at.bridging_energy > 0),
                "bridging_strength or bridging_energy is 0; both are, or neither");
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<KindRow> kind_rows() {
    const std::string file = materials().below("kinds/surface.tsv").string();
    return file.empty() ? std::vector<KindRow>() : read_kind_rows(file);
}

std::optional<KindSurface> KindSurface::of(const Material& material, std::string* why) {
    const auto none = [&](const std::string& reason) {
        if (why != nullptr) *why = reason;
        return std::optional<KindSurface>();
    };
    std::vector<KindRow> rows = kind_rows();
    if (rows.empty()) return none("there is no kinds/surface.tsv beside the materials");
    const auto own = fixed_traits(material);
    std::optional<std::vector<std::string>> least;
    for (const RockKind& kind : rock_kinds()) {
        if (!material.kind.empty() && material.kind != kind.name) continue;
        if (std::ranges::none_of(rows, [&](const KindRow& row) { return row.kind == kind.name; })) continue;
        const std::vector<std::string> found = differences_from(kind, own);
        if (found.empty() && !material.grains.grain_size) return none("its fabric.grain_size is not given");
        if (found.empty()) return KindSurface(std::move(rows), kind.name);
        if (!least || found.size() < least->size()) least = found;
    }
    return none(least                   ? least->front()
                : material.kind.empty() ? "kinds/surface.tsv has no kind that is beside the materials"
                                        : fmt::format("its kind {} has no surface", material.kind));
}

KindSurface::KindSurface(std::vector<KindRow> rows, std::string kind) : kind_(std::move(kind)) {
    const auto rocks = std::stable_partition(rows.begin(), rows.end(), [](const KindRow& row) { return !row.is_rock; });
    for (auto row = rows.begin(); row != rocks; ++row) {
        if (row->kind != usual_kind && std::ranges::count(kinds_, row->kind) == 0) kinds_.push_back(row->kind);
        const auto widen = [](double& least, double& most, double value) {
            if (value > 0 && (most == 0 || value < least)) least = value;
            most = std::max(most, value);
        };
        for (const Bounded& each : bounded) widen(least_.*each.coordinate, most_.*each.coordinate, row->at.*each.coordinate);
        widen(least_pressure_, most_pressure_, row->confining_pressure);
    }
    least_.bridging_strength = 0;
    const auto factors_in = [&](const KindRow& row) { return factors_of(row.at, row.confining_pressure, row.kind, kinds_); };
    for (const Property& property : all_properties()) {
        std::vector<std::vector<double>> factors;
        std::vector<double> logarithms;
        std::vector<std::string> specimens;  // of a point: several discs, or one under several pressures; the same of all kinds
        std::map<std::tuple<std::string, std::string, double>, int> tested;
        bool has_kind = false;
        for (auto row = rows.begin(); row != rocks; ++row) {
            if (row->property != property.name) continue;
            const int nth = tested[{row->kind, row->point, row->confining_pressure}]++;
            specimens.push_back(fmt::format("{} {}", row->point, nth));
            factors.push_back(factors_in(*row));
            logarithms.push_back(std::log(row->value) - log_unit(property, row->at));
            has_kind |= row->kind == kind_;
        }
        if (!has_kind) continue;
        KindModel model = fit_model(property.name, factors, logarithms, specimens);
        double sum = 0;
        int n = 0;
        std::set<std::string> names;
        for (auto row = rocks; row != rows.end(); ++row) {
            if (row->property != property.name || !holds(row->at, row->confining_pressure)) continue;
            const std::vector<double> at = factors_in(*row);
            sum += std::pow(std::log(row->value) - log_unit(property, row->at) - model.value(at), 2) -
                   model.variance * (1 / row->specimens + model.leverage(at));
            ++n;
            names.insert(row->point);
        }
        model.rocks = static_cast<int>(names.size());
        model.rock_variance = std::max(floor_of_rocks * floor_of_rocks, n > 0 ? sum / n : 0);
        models_.emplace_back(property.name, std::move(model));
    }
}

int KindModel::freedom_of_mean(const std::vector<double>& at) const {
    const double of_fit = variance * leverage(at);
    const double of_rocks = rocks > 0 ? rock_variance * rock_variance / rocks : 0;  // without rocks the variance is the floor
    return static_cast<int>(std::pow(of_fit + rock_variance, 2) / (of_fit * of_fit / freedom + of_rocks));
}

std::string KindSurface::specimen_of(const Property& property) {
    const bool is_rectangle = property.loading == Loading::compression || property.loading == Loading::tension;
    const bool is_pulled = property.loading == Loading::bending || property.loading == Loading::tension;
    return std::string(is_rectangle ? "300 crystals" : "") + (is_rectangle && is_pulled ? ", " : "") +
           (is_pulled ? "plane stress" : "");
}

std::string KindSurface::name_of(const SurfaceTerm& term) const {
    std::string name;
    for (std::size_t k = 0; k < term.power.size(); ++k) {
        const std::string factor = k < continuous.size() ? continuous[k].name : "is_" + kinds_[k - continuous.size()];
        if (term.power[k] > 0) name += (name.empty() ? "" : " ") + factor + (term.power[k] > 1 ? "^2" : "");
    }
    return name.empty() ? "1" : name;
}

const KindModel* KindSurface::model(const Property& property, double confining_pressure) const {
    if ((property.pressure == PressureOf::name) != (confining_pressure > 0)) return nullptr;
    const auto found = std::ranges::find_if(models_, [&](const auto& each) { return each.first == property.name; });
    return found == models_.end() ? nullptr : &found->second;
}

std::vector<double> KindSurface::factors(const KindCoordinates& at, double confining_pressure) const {
    return factors_of(at, confining_pressure, kind_, kinds_);
}

double KindSurface::log_unit(const Property& property, const KindCoordinates& at) {
    const double unit = std::log(at.tensile_strength);
    if (property.quantity.dimension == Dimension::toughness) return unit + std::log(at.grain_size) / 2;
    if (property.name != "crack_initiation") return unit;
    return unit + initiation_exponent * std::log(at.contact_strain / KindCoordinates{}.contact_strain);
}

std::string KindSurface::beyond(const KindCoordinates& at, double confining_pressure) const {
    constexpr double rounding = 1e-6;  // of a table
    const auto check = [](const char* name, double value, double least, double most) {
        if (value >= least * (1 - rounding) && value <= most * (1 + rounding)) return std::string();
        return fmt::format("its {} is {:.4g}, those of the design {:.4g} to {:.4g}", name, value, least, most);
    };
    std::string found;
    for (const auto& [name, coordinate, shown] : bounded) {
        const bool is_without = coordinate == &KindCoordinates::bridging_energy && at.bridging_strength == 0;
        if (!found.empty() || is_without) continue;
        found = check(name, at.*coordinate * shown, least_.*coordinate * shown, most_.*coordinate * shown);
    }
    if (!found.empty() || confining_pressure == 0) return found;
    return check("confining pressure over tc", confining_pressure / at.tensile_strength, least_pressure_, most_pressure_);
}

std::optional<KindPrediction> KindSurface::predict(const KindCoordinates& at, const Property& property,
                                                   double confining_pressure) const {
    const KindModel* const found = model(property, confining_pressure);
    if (found == nullptr || !holds(at, confining_pressure)) return std::nullopt;
    const std::vector<double> here = factors(at, confining_pressure);
    const double of_mean = found->variance * found->leverage(here) + found->rock_variance;
    return KindPrediction{std::exp(found->value(here) + log_unit(property, at)), std::sqrt(of_mean),
                          std::sqrt(of_mean + found->variance)};
}

void write_kind_terms(std::ostream& out, const KindSurface& surface, TableFormat format) {
    TableWriter table(
        out, {"property", "term", "coefficient", "standard_error", "scatter", "rock_deviation", "prediction_error", "specimens"},
        format);
    for (const auto& [property, model] : surface.models()) {
        for (std::size_t k = 0; k < model.terms.size(); ++k) {
            table.row({property, surface.name_of(model.terms[k]), model.coefficients(static_cast<Eigen::Index>(k)),
                       model.standard_error(k), model.scatter(), std::sqrt(model.rock_variance), model.prediction_error(),
                       model.n_values});
        }
    }
}

void write_kind_rocks(std::ostream& out, const KindSurface& surface, const std::vector<KindRow>& rows, TableFormat format) {
    TableWriter table(out,
                      {"rock", "property", "confining_pressure", "measured", "predicted", "specimens", "off_percent",
                       "low_percent", "high_percent"},
                      format);
    for (const KindRow& row : rows) {
        if (!row.is_rock || row.kind != surface.kind()) continue;
        const Property& property = property_named(row.property);
        std::vector<Cell> cells{row.point, row.property, row.confining_pressure, row.value, {}, row.specimens, {}, {}, {}};
        if (const auto found = surface.predict(row.at, property, row.confining_pressure)) {
            const KindModel& model = *surface.model(property, row.confining_pressure);
            const double deviation =
                std::sqrt(std::pow(found->mean_deviation, 2) - model.rock_variance + model.variance / row.specimens);
            const auto off = [&](double deviations) {
                return 100 * (found->value / row.value * std::exp(deviations * deviation) - 1);
            };
            cells[4] = found->value;
            cells[6] = off(0);
            cells[7] = off(-deviations_of_95_percent);
            cells[8] = off(deviations_of_95_percent);
        }
        table.row(cells);
    }
}

}  // namespace graincrack
