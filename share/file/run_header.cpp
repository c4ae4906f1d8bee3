#include "share/file/run_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "share/base/error.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

/// A property of phases or classes of contacts: its dataset and its member.
template <class Row>
struct Property {
    const char* name;
    double Row::*member;
    Dimension dimension;
    bool may_lack = false;  ///< a file may lack it: it is then 0
};
constexpr std::array<Property<Phase>, 4> phase_properties{
    {{"young_modulus", &Phase::young_modulus, Dimension::stress},
     {"poisson_ratio", &Phase::poisson_ratio, Dimension::one},
     {"density", &Phase::density, Dimension::density},
     {"thermal_expansion", &Phase::thermal_expansion, Dimension::expansion, true}}};
const std::vector<Property<ContactParameters>>& contact_properties() {
    static const std::vector<Property<ContactParameters>> all = [] {
        std::vector<Property<ContactParameters>> rows;
        for (const ContactParameter& row : all_contact_parameters()) {
            rows.push_back({row.quantity.name.data(), row.value, row.quantity.dimension, row.may_lack});
        }
        rows.push_back({"critical_opening", &ContactParameters::critical_opening, Dimension::length});
        rows.push_back({"critical_sliding", &ContactParameters::critical_sliding, Dimension::length});
        rows.push_back({"ultimate_opening", &ContactParameters::ultimate_opening, Dimension::length});
        return rows;
    }();
    return all;
}

/// Visits every attribute of /run once, for writing and reading alike.
template <class Header, class Visit>
void visit_header(Header& h, Visit&& visit) {
    visit("test", h.test);
    visit("material", h.material);
    visit("contact_law", h.contact_law);
    visit("fracture_energy_choice", h.fracture_energy_choice);
    visit("young_modulus", h.rock.young_modulus, Dimension::stress);
    visit("poisson_ratio", h.rock.poisson_ratio, Dimension::one);
    visit("density", h.rock.density, Dimension::density);
    visit("mode_i_toughness", h.rock.mode_i_toughness, Dimension::toughness);
    visit("mode_ii_toughness", h.rock.mode_ii_toughness, Dimension::toughness);
    visit("tensile_strength", h.rock.tensile_strength, Dimension::stress);
    for (const auto& [name, member, dimension, may_lack] : contact_properties()) {
        visit(name, h.contact.*member, dimension, may_lack);
    }
    visit("platen_friction", h.platen_friction, Dimension::angle);
    visit("confining_pressure", h.confining_pressure, Dimension::stress);
    visit("rate", h.rate);
    visit("rate_tolerance", h.rate_tolerance, Dimension::one);
    visit("rate_share", h.rate_share, Dimension::one);
    visit("platen_speed", h.platen_speed, Dimension::speed);
    visit("damping", h.damping, Dimension::one);
    visit("damping_form", h.damping_form);
    visit("peak_drop", h.peak_drop, Dimension::one);
    visit("max_strain", h.max_strain, Dimension::one);
    visit("mass_scaling", h.mass_scaling);
    visit("mass_scaling_factor", h.mass_scaling_factor, Dimension::one);
    visit("added_mass", h.added_mass, Dimension::one);
    visit("stable_time_step", h.stable_time_step, Dimension::time);
    visit("time_step", h.time_step, Dimension::time);
    visit("stop_reason", h.stop_reason);
    visit("steps", h.steps);
    visit("integrations", h.integrations);
    visit("isotropic_end_time", h.isotropic_end_time, Dimension::time);
    visit("peak_axial_stress", h.peak_axial_stress, Dimension::stress);
    visit("peak_time", h.peak_time, Dimension::time, true);
    visit("energy_scale", h.energy_scale, Dimension::energy);
    visit("energy_balance_error", h.energy_balance_error, Dimension::one);
    visit("platen_force_difference", h.platen_force_difference, Dimension::one);
    visit("confinement_mean", h.confinement_mean, Dimension::stress);
    visit("confinement_deviation", h.confinement_deviation, Dimension::stress);
    visit("damping_share", h.damping_share, Dimension::one);
    visit("damping_load", h.damping_load, Dimension::one);
}

struct HeaderWriter {
    H5Output& file;
    void operator()(const char* name, const std::string& value) const { file.attribute(schema::run_group, name, value); }
    void operator()(const char* name, const std::int64_t& value) const { file.attribute(schema::run_group, name, value); }
    void operator()(const char* name, const double& value, Dimension dimension, bool /*may_lack*/ = false) const {
        file.quantity(schema::run_group, name, value, si_unit(dimension));
    }
};

struct HeaderReader {
    const H5Input& file;
    void operator()(const char* name, std::string& value) const { value = file.attribute<std::string>(schema::run_group, name); }
    void operator()(const char* name, std::int64_t& value) const {
        value = file.attribute<std::int64_t>(schema::run_group, name);
    }
    void operator()(const char* name, double& value, Dimension /*dimension*/, bool may_lack = false) const {
        value =
            may_lack ? file.attribute_or<double>(schema::run_group, name, 0) : file.attribute<double>(schema::run_group, name);
        if (!std::isfinite(value)) {
            throw InputError(fmt::format("{}: attribute {} of {} is {}; a finite number is needed", file.name(), name,
                                         schema::run_group, value));
        }
    }
};

/// Visits the properties that depend on temperature: expansion of each phase along and across its axis, and modulus_factor.
template <class Phases, class Visit>
void visit_curves(Phases& phases, const std::vector<std::string>& names, Visit&& visit) {
    for (std::size_t p = 0; p < std::min(phases.size(), names.size()); ++p) {
        const auto path = [&](const char* what) { return fmt::format("{}/{}_of_{}", schema::phases_group, what, names[p]); };
        visit(path("thermal_expansion"), phases[p].along);
        visit(path("thermal_expansion_across"), phases[p].across);
        visit(path("softening"), phases[p].softening);
    }
}

/// Name of a phase from the class of its contacts with itself, "quartz-quartz".
std::string phase_of_class(const std::vector<std::string>& class_names, std::size_t phase) {
    const std::size_t k = contact_class(phase, phase);
    return k < class_names.size() ? class_names[k].substr(0, class_names[k].size() / 2) : fmt::format("phase {}", phase);
}

}  // namespace

std::string RunSettings::heat_label() const {
    if (heat == 0) return "";
    return cooled != 0 ? fmt::format("heated by {:.4g} K and cooled", heat) : fmt::format("at {:+.4g} K", heat);
}

Settings material_values(const MaterialSettings& material) {
    Settings values;
    const auto add = [&values](const auto& properties, const auto& row, const std::string& whose) {
        for (const auto& [name, member, dimension, may_lack] : properties) {
            values.push_back({name + whose, row.*member, dimension, SettingGroup::material});
        }
    };
    add(phase_properties, phase_of(material.rock), "");
    const auto add_contact = [&values](const ContactParameters& contact, const std::string& whose) {
        for (const ContactParameter& row : all_contact_parameters()) {
            values.push_back(
                {std::string(row.quantity.name) + whose, contact.*row.value, row.quantity.dimension, SettingGroup::material});
        }
    };
    add_contact(material.contact, "");
    std::vector<std::string> phases;
    for (std::size_t p = 0; p < material.fabric.phases.size(); ++p) {
        phases.push_back(phase_of_class(material.class_names, p));
        add(phase_properties, material.fabric.phases[p], " of " + phases.back());
    }
    visit_curves(material.fabric.phases, phases, [&](const std::string& path, const TemperatureCurve& curve) {
        if (curve.empty()) return;
        std::vector<double> numbers;
        for (const auto& [temperature, value] : curve) numbers.insert(numbers.end(), {temperature, value});
        values.push_back({path.substr(path.rfind('/') + 1), numbers, Dimension::one, SettingGroup::material});
    });
    for (std::size_t k = 0; k < material.fabric.contacts.size(); ++k) {
        const std::string name = k < material.class_names.size() ? material.class_names[k] : fmt::format("class {}", k);
        add_contact(material.fabric.contacts[k], " of " + name);
    }
    return values;
}

void write_header(H5Output& file, const RunHeader& header) {
    file.create_group(schema::run_group);
    write_settings(file, schema::run_group, header.request);
    file.attribute(schema::run_group, "plane", std::string(name_of(header.plane)));
    file.attribute(schema::run_group, "crack_event", std::string(name_of(header.crack_event)));
    visit_header(header, HeaderWriter{file});
    if (header.span > 0) file.quantity(schema::run_group, "span", header.span, "m");
    if (header.heat != 0) {
        file.quantity(schema::run_group, "heat", header.heat, "K");
        file.attribute(schema::run_group, "cooled", header.cooled);
    }
}

namespace {

/// Writes properties of phases or classes as datasets of a group, one per property.
template <class Properties, class Row>
void write_properties(H5Output& file, const std::string& group, const std::vector<std::string>& names,
                      const Properties& properties, const std::vector<Row>& rows) {
    file.create_group(group);
    file.attribute(group, "names", names);
    for (const auto& [name, member, dimension, may_lack] : properties) {
        std::vector<double> values;
        for (const Row& row : rows) values.push_back(row.*member);
        file.write<double>(group + "/" + name, std::span<const double>(values), {names.size()}, si_unit(dimension),
                           "by index of the attribute names of the group");
    }
}

/// Reads properties into existing rows. \throws InputError
template <class Properties, class Row>
void read_properties(const H5Input& file, const std::string& group, const Properties& properties, std::vector<Row>& rows) {
    for (const auto& [name, member, dimension, may_lack] : properties) {
        if (may_lack && !file.has(group + "/" + name)) continue;
        const std::vector<double> values = file.read<double>(group + "/" + name, {rows.size()});
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!std::isfinite(values[i])) {
                throw InputError(
                    fmt::format("{}: {}/{} has the value {}; a finite number is needed", file.name(), group, name, values[i]));
            }
            rows[i].*member = values[i];
        }
    }
}

}  // namespace

void write_fabric(H5Output& file, const RunHeader& header, const Specimen& specimen) {
    const Fabric fabric =
        header.fabric.phases.empty() ? uniform_fabric(header.rock, header.contact, specimen.phase_names.size()) : header.fabric;
    const std::size_t n_cold = phase_properties.size() - 1;
    write_properties(file, schema::phases_group, specimen.phase_names,
                     std::span(phase_properties).first(fabric.feels_temperature() ? phase_properties.size() : n_cold),
                     fabric.phases);
    if (fabric.has_axes()) write_rows(file, schema::grain_axis, crystal_axes(specimen));
    visit_curves(fabric.phases, specimen.phase_names, [&](const std::string& path, const TemperatureCurve& curve) {
        if (!curve.empty()) write_rows(file, {path.c_str(), "1", "a row a temperature: K, value there"}, curve);
    });
    write_properties(file, schema::classes_group, contact_class_names(specimen), contact_properties(), fabric.contacts);
}

namespace {

Fabric read_fabric(const H5Input& file) {
    const std::size_t n_phases = rows_of(file, std::string(schema::phases_group) + "/young_modulus");
    if (n_phases < 1 || n_phases > max_phases) {
        throw InputError(
            fmt::format("{}: {} has {} phases; 1 to {} are needed", file.name(), schema::phases_group, n_phases, max_phases));
    }
    const std::size_t n_classes = rows_of(file, std::string(schema::classes_group) + "/contact_cohesion");
    if (n_classes < n_contact_classes(n_phases) || n_classes > max_classes) {
        throw InputError(fmt::format("{}: {} has {} classes, and {} phases have {} at least", file.name(), schema::classes_group,
                                     n_classes, n_phases, n_contact_classes(n_phases)));
    }
    Fabric fabric{std::vector<Phase>(n_phases), std::vector<ContactParameters>(n_classes)};
    read_properties(file, schema::phases_group, phase_properties, fabric.phases);
    visit_curves(fabric.phases, file.attribute<std::vector<std::string>>(schema::phases_group, "names"),
                 [&](const std::string& path, TemperatureCurve& curve) {
                     if (file.has(path)) curve = rows_from<std::array<double, 2>>(file.read<double>(path));
                 });
    read_properties(file, schema::classes_group, contact_properties(), fabric.contacts);
    return fabric;
}

CrackEvent read_crack_event(const H5Input& file) {
    const auto name = file.attribute<std::string>(schema::run_group, "crack_event");
    const auto* const event =
        std::find_if(all_crack_events.begin(), all_crack_events.end(), [&](CrackEvent e) { return name_of(e) == name; });
    if (event == all_crack_events.end()) {
        throw InputError(fmt::format("{}: attribute crack_event of {} is \"{}\"; failed, half-damaged or broken is needed",
                                     file.name(), schema::run_group, name));
    }
    return *event;
}

}  // namespace

RunHeader read_header(const H5Input& file) {
    RunHeader header;
    const auto plane = file.attribute<std::string>(schema::run_group, "plane");
    header.plane = plane == "stress" ? PlaneCondition::stress : PlaneCondition::strain;
    header.crack_event = read_crack_event(file);
    visit_header(header, HeaderReader{file});
    header.fabric = read_fabric(file);
    header.class_names = file.attribute<std::vector<std::string>>(schema::classes_group, "names");
    header.request = read_settings(file, schema::run_group);
    header.span = file.attribute_or<double>(schema::run_group, "span", 0);
    header.heat = file.attribute_or<double>(schema::run_group, "heat", 0);
    header.cooled = file.attribute_or<std::int64_t>(schema::run_group, "cooled", 0);
    if (!(header.span >= 0 && std::isfinite(header.span)) || (header.loading() == Loading::bending && header.span == 0)) {
        throw InputError(fmt::format("{}: attribute span of {} is {}; a test in bending needs a positive number, others none",
                                     file.name(), schema::run_group, header.span));
    }
    if (header.time_step <= 0 || header.steps < 0) {
        throw InputError(
            fmt::format("{}: time_step and steps of {} are {} and {}; a positive step and no negative number are needed",
                        file.name(), schema::run_group, header.time_step, header.steps));
    }
    return header;
}

}  // namespace graincrack
