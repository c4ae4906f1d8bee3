#include "post/run/comparability.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "post/run/test_label.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"
#include "share/base/toml_file.hpp"

namespace graincrack {
namespace {

constexpr const char *measured_material = "material", *minerals = "minerals";

/// The name of a setting in words, "contact cohesion of within_quartz": a class of contacts keeps its name.
std::string words_of(std::string name) {
    const std::size_t of = name.find(" of ");
    std::replace(name.begin(), of == std::string::npos ? name.end() : name.begin() + static_cast<std::ptrdiff_t>(of), '_', ' ');
    return name;
}

ComparedSetting compared(SettingGroup group, const std::string& name, SettingValue value, Dimension dimension = Dimension::one,
                         double tolerance = 1e-9) {
    return {{name, std::move(value), dimension, group}, tolerance, 0, false, ""};
}

/// True if a value of a class of contacts is of the specimen and not of the material: the stiffness within crystals is as large
/// as the length of the contacts there wants.
bool is_of_specimen(const ContactParameter& row, const std::string& class_name) {
    const bool is_stiffness =
        row.value == &ContactParameters::normal_stiffness || row.value == &ContactParameters::shear_stiffness;
    return is_stiffness && !phase_of_within_class(class_name).empty();
}

/// The parameter of contacts that a value of a material is, and the class of contacts that has it; nothing for others.
std::optional<std::pair<const ContactParameter*, std::string>> contact_value(const std::string& name) {
    constexpr std::string_view of = " of ";
    const std::size_t end = name.find(of);
    for (const ContactParameter& row : all_contact_parameters()) {
        if (row.quantity.name == name.substr(0, end)) {
            return std::pair(&row, end == std::string::npos ? "" : name.substr(end + of.size()));
        }
    }
    return std::nullopt;
}

/// Holes and cracks that no setting tells, as of a specimen that was imported.
std::string cuts_of(const RunData& run) {
    const SpecimenSummary& s = run.specimen;
    const auto is_cut = [](const Setting& each) {
        return each.group == SettingGroup::cuts && !std::holds_alternative<std::monostate>(each.value);
    };
    if (std::ranges::any_of(s.settings, is_cut)) return "";
    std::vector<std::string> cuts;
    if (s.holes > 0) cuts.push_back(counted(s.holes, "hole"));
    if (s.is_cracked) cuts.emplace_back("cracks");
    const RunSettings& h = run.header;
    for (std::size_t k = n_contact_classes(h.fabric.phases.size()); k < h.class_names.size(); ++k) {
        if (phase_of_within_class(h.class_names[k]).empty()) cuts.push_back(h.class_names[k]);
    }
    return fmt::format("{}", fmt::join(cuts, " and "));
}

bool is_round(const SpecimenSummary& s) { return s.shape == "disc" || s.shape == "ring" || s.shape == "half-disc"; }

/// The minerals with their fractions of the area, which are reached to single grains.
void add_minerals(ComparedSettings& all, const SpecimenSummary& s) {
    std::vector<std::string> names;
    for (const auto& [name, fraction] : s.phases) names.push_back(name);
    all.push_back(compared(SettingGroup::material, minerals, fmt::format("{}", fmt::join(names, " "))));
    all.back().follows = measured_material;
    for (const auto& [name, fraction] : s.phases) {
        ComparedSetting& each = all.emplace_back(compared(SettingGroup::material, name, fraction));
        each.slack = 0.03 + 2 / static_cast<double>(std::max<std::int64_t>(1, s.crystals));
        each.follows = minerals;
    }
}

/// What specimens of any origin are measured to be.
void add_measures(ComparedSettings& all, const RunData& run) {
    constexpr double same_length = 1e-6, of_draws = 0.05, of_elements = 0.1, of_rims = 0.03;
    const SpecimenSummary& s = run.specimen;
    const auto add = [&all](SettingGroup group, const char* name, SettingValue value, Dimension dimension, double tolerance) {
        all.push_back(compared(group, name, std::move(value), dimension, tolerance));
    };
    all.push_back(compared(SettingGroup::shape, "shape", s.shape));
    add(SettingGroup::size, is_round(s) ? "diameter" : "width", s.width, Dimension::length, same_length);
    if (!is_round(s)) add(SettingGroup::size, "height", s.height, Dimension::length, same_length);
    add(SettingGroup::size, "span", run.header.span, Dimension::length, same_length);
    all.push_back(compared(SettingGroup::cuts, "cut", cuts_of(run)));
    add(SettingGroup::grain_size, "grain diameter", s.grain_diameter, Dimension::length, of_draws);
    all.push_back(compared(SettingGroup::fabric, "tessellation", s.tessellation));
    add(SettingGroup::fabric, "elements a crystal", s.elements_per_crystal, Dimension::one, of_elements);
    const bool asks_for_scatter = find_setting(s.settings, "strength_modulus") != nullptr;
    all.push_back(compared(SettingGroup::fabric, "scatter of strengths", s.has_strength_factors && !asks_for_scatter));
    add(SettingGroup::size, "area", s.area, Dimension::area, of_rims);
    all.back().follows = is_round(s) ? "diameter" : "width";
}

/// Adds what was asked for, but for what is there already: a measure of what came out of it.
void add_settings(ComparedSettings& all, const Settings& settings) {
    for (const Setting& each : settings) {
        const std::string name = words_of(each.name);
        const bool is_there = std::ranges::any_of(all, [&](const ComparedSetting& c) { return c.setting.name == name; });
        if (is_there || each.group == SettingGroup::none || each.group == SettingGroup::seed) continue;
        all.push_back({{name, each.value, each.dimension, each.group}});
        if (each.group == SettingGroup::material) all.back().follows = minerals;
    }
    // The same grains, loaded along another diameter, are others as a seed makes them, unless they have a direction.
    const bool is_directed = std::ranges::any_of(settings, [](const Setting& each) {
        const bool is_given = !std::holds_alternative<std::monostate>(each.value);
        return is_given && (each.group == SettingGroup::cuts || each.name == "elongation_angle");
    });
    const Setting* const diameter = find_setting(settings, "loaded_diameter");
    if (is_directed && diameter != nullptr) all.push_back(compared(SettingGroup::cuts, "loaded diameter", diameter->value));
}

/// Whether two values are the same, but for what draws make of one.
bool is_same(const ComparedSetting& a, const ComparedSetting& b) {
    const auto is_near = [&](double x, double y) {
        return x == y || std::abs(x - y) <= std::max({a.tolerance * std::max(std::abs(x), std::abs(y)), a.slack, b.slack});
    };
    const SettingValue &own = a.setting.value, &other = b.setting.value;
    if (own.index() != other.index()) return false;
    if (const auto* const number = std::get_if<double>(&own)) return is_near(*number, std::get<double>(other));
    const auto* const numbers = std::get_if<std::vector<double>>(&own);
    if (numbers == nullptr) return own == other;
    const auto& others = std::get<std::vector<double>>(other);
    return std::equal(numbers->begin(), numbers->end(), others.begin(), others.end(), is_near);
}

/// "30 mm", with as many digits as tell it from another; "none" for what a run does not have.
std::string value_beside(const ComparedSetting& compared, const ComparedSetting& other) {
    constexpr int usual = 4, of_draws = 2, all = 10;
    const int digits = compared.tolerance > 1e-3 ? of_draws : usual;
    const std::string value = shown(compared.setting, digits);
    return value == shown(other.setting, digits) ? shown(compared.setting, all) : value;
}

const ComparedSetting* find(const ComparedSettings& settings, std::size_t near, const std::string& name) {
    if (near < settings.size() && settings[near].setting.name == name) return &settings[near];
    const auto found = std::ranges::find_if(settings, [&](const ComparedSetting& each) { return each.setting.name == name; });
    return found == settings.end() ? nullptr : &*found;
}

/// The settings in which two runs differ, of both. What only one of them has needs no comparison: other settings tell it.
std::vector<std::pair<const ComparedSetting*, const ComparedSetting*>> differing(const ComparedSettings& a,
                                                                                 const ComparedSettings& b,
                                                                                 const SettingGroups& except) {
    const bool is_one_plane = find(a, 0, "plane")->setting.value == find(b, 0, "plane")->setting.value;
    std::vector<std::pair<const ComparedSetting*, const ComparedSetting*>> pairs;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (except.count(a[i].setting.group) > 0 || (a[i].follows_plane && !is_one_plane)) continue;
        const ComparedSetting* const other = find(b, i, a[i].setting.name);
        if (other != nullptr && !is_same(a[i], *other)) pairs.emplace_back(&a[i], other);
    }
    return pairs;
}

std::vector<ComparedSettings> all_settings(const RunList& runs) {
    std::vector<ComparedSettings> all;
    for (const RunData* run : runs) all.push_back(compared_settings(*run));
    return all;
}

/// Whether a setting is to be told beside those told before, which has to be: what it follows is the same.
bool tell(std::set<std::string>& told, const ComparedSetting& each) {
    told.insert(each.setting.name);
    return told.count(each.follows) == 0;
}

/// The order of tables: Brazilian, tension and bending, compression by rising pressure, then test, shape and size of the grains.
std::tuple<int, double, std::string, std::string, double> table_order(const RunData& run) {
    constexpr double size_unit = 1e-4;  // m: draws do not decide
    const RunHeader& h = run.header;
    const int order = h.loading() == Loading::splitting ? 0 : h.loading() == Loading::compression ? 2 : 1;
    return {order, h.confining_pressure, h.test, distinct_shape(run), std::round(run.specimen.grain_diameter / size_unit)};
}

}  // namespace

ComparedSettings compared_material(const MaterialSettings& material) {
    ComparedSettings all{compared(SettingGroup::plane, "plane", std::string(name_of(material.plane))),
                         compared(SettingGroup::material, measured_material, material.material),
                         compared(SettingGroup::material, "contact law", material.contact_law),
                         compared(SettingGroup::material, "choice of the fracture energy", material.fracture_energy_choice)};
    for (std::size_t i = 2; i < all.size(); ++i) all[i].follows = measured_material;
    for (const Setting& value : material_values(material)) {
        const auto contact = contact_value(value.name);
        if (contact && is_of_specimen(*contact->first, contact->second)) continue;
        const std::string name = words_of(value.name);
        const std::size_t of = name.find(" of ");
        all.push_back({{name, value.value, value.dimension, value.group}});
        all.back().follows = of == std::string::npos ? measured_material : name.substr(0, of);
        all.back().follows_plane = contact && contact->first->follows_plane;
    }
    return all;
}

ComparedSettings compared_settings(const RunData& run) {
    const RunSettings& h = run.header;
    ComparedSettings all = compared_material(h);
    all.insert(all.begin() + 1,
               {compared(SettingGroup::test, "test", h.test),
                compared(SettingGroup::pressure, "confining pressure", h.confining_pressure, Dimension::stress)});
    all.push_back(compared(SettingGroup::heat, "heat", h.heat_label()));
    all.push_back(compared(SettingGroup::loading, "program", toml_content(parse_toml(run.program, run.name))));
    add_minerals(all, run.specimen);
    add_measures(all, run);
    add_settings(all, run.specimen.settings);
    add_settings(all, h.request);
    return all;
}

std::string differences(const ComparedSettings& a, const ComparedSettings& b, const SettingGroups& except) {
    constexpr std::size_t most = 5;
    std::vector<std::string> list;
    std::set<std::string> told;
    for (const auto& [one, other] : differing(a, b, except)) {
        if (!tell(told, *one)) continue;
        list.push_back(fmt::format("{} ({}, {})", one->setting.name, value_beside(*one, *other), value_beside(*other, *one)));
    }
    const std::size_t more = list.size() > most ? list.size() - most : 0;
    list.resize(list.size() - more);
    return fmt::format("{}", fmt::join(list, ", ")) + (more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string differences(const RunData& a, const RunData& b, const SettingGroups& except) {
    return differences(compared_settings(a), compared_settings(b), except);
}

RunList list_of(const std::vector<RunData>& runs) {
    RunList list;
    for (const RunData& run : runs) list.push_back(&run);
    return list;
}

std::vector<std::string> distinctions(const RunList& runs, const SettingGroups& except) {
    const auto settings = all_settings(runs);
    SettingGroups untold = except;
    untold.insert({SettingGroup::test, SettingGroup::pressure});
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        std::map<std::string, std::string> told;
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const bool is_one_test = except.count(SettingGroup::test) > 0 || series_label(*runs[i]) == series_label(*runs[k]);
            if (!is_one_test) continue;
            std::set<std::string> seen;
            for (const auto& [own, other] : differing(settings[i], settings[k], untold)) {
                const std::string value = value_beside(*own, *other);
                if (!tell(seen, *own) || value == "none") continue;
                told[own->setting.name] =
                    own->setting.name == "material" || own->setting.name == "heat" ? value : own->setting.name + " " + value;
            }
        }
        std::vector<std::string> list;
        for (const ComparedSetting& each : settings[i]) {
            if (told.count(each.setting.name) > 0) list.push_back(told[each.setting.name]);
        }
        texts.push_back(fmt::format("{}", fmt::join(list, ", ")));
    }
    return texts;
}

std::vector<ComparableGroup> comparable_groups(const RunList& runs, const SettingGroups& except, const SettingGroups& untold) {
    const auto settings = all_settings(runs);
    std::vector<std::size_t> by_size(runs.size());
    std::iota(by_size.begin(), by_size.end(), std::size_t{0});
    std::ranges::stable_sort(by_size, {},
                             [&](std::size_t i) { return std::pair(runs[i]->specimen.grain_diameter, runs[i]->specimen.area); });
    std::vector<ComparableGroup> groups;
    for (const std::size_t i : by_size) {
        const auto holds = [&](const ComparableGroup& group) {
            return std::ranges::all_of(group.runs,
                                       [&](std::size_t k) { return differing(settings[i], settings[k], except).empty(); });
        };
        const auto own = std::ranges::find_if(groups, holds);
        if (own == groups.end()) {
            groups.push_back({{i}, ""});
        } else {
            own->runs.push_back(i);
        }
    }
    for (ComparableGroup& group : groups) std::ranges::sort(group.runs);
    const auto order = [&](const ComparableGroup& group) { return std::pair(table_order(*runs[group.runs[0]]), group.runs[0]); };
    std::ranges::sort(groups, {}, order);
    RunList firsts;
    for (const ComparableGroup& group : groups) firsts.push_back(runs[group.runs[0]]);
    SettingGroups all = except;
    all.insert(untold.begin(), untold.end());
    const std::vector<std::string> told = distinctions(firsts, all);
    for (std::size_t g = 0; g < groups.size(); ++g) groups[g].distinction = told[g];
    return groups;
}

std::string common_material(const std::vector<RunData>& runs, const std::string& otherwise) {
    const std::string& name = runs.front().header.material;
    const bool is_common = std::ranges::all_of(runs, [&](const RunData& run) { return run.header.material == name; });
    return is_common && !name.empty() ? name : otherwise;
}

std::vector<std::string> names_apart(const std::vector<RunData>& runs) {
    const std::vector<std::string> told = distinctions(list_of(runs));
    std::vector<std::string> names;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        names.push_back(series_label(runs[i]) + (told[i].empty() ? "" : ", ") + told[i]);
    }
    const auto add = [&](const auto& text_of) {
        std::map<std::string, std::set<std::string>> texts;
        for (std::size_t i = 0; i < runs.size(); ++i) texts[names[i]].insert(text_of(runs[i]));
        for (std::size_t i = 0; i < runs.size(); ++i) names[i] += texts[names[i]].size() > 1 ? ", " + text_of(runs[i]) : "";
    };
    add([](const RunData& run) { return fmt::format("seed {}", run.specimen.seed); });
    add([](const RunData& run) { return std::filesystem::path(run.name).filename().string(); });
    return names;
}

void require_comparable(const std::vector<RunData>& runs, const std::string& what, const SettingGroups& except) {
    std::map<std::tuple<std::string, double, std::string>, std::vector<std::size_t>> tests;
    const auto settings = all_settings(list_of(runs));
    SettingGroups of_others = of_the_test;
    of_others.insert(except.begin(), except.end());
    const std::string others = except.empty() ? "one kind that differ in their seeds only" : "one kind otherwise";
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const RunSettings& h = runs[i].header;
        std::vector<std::size_t>& test = tests[{h.test, h.confining_pressure, distinct_shape(runs[i])}];
        const bool is_first = test.empty();
        for (const std::size_t k : is_first ? std::vector<std::size_t>{0} : test) {
            const std::string found = differences(settings[i], settings[k], is_first ? of_others : except);
            if (found.empty()) continue;
            throw InputError(runs[i].name + ": differs from " + runs[k].name + " in " + found + "; " + what + " needs tests of " +
                             (is_first ? "one material and fabric" : others));
        }
        test.push_back(i);
    }
}

bool is_same_run(const RunData& a, const RunData& b) {
    return a.specimen.seed == b.specimen.seed && a.specimen_digest == b.specimen_digest &&
           (!a.specimen_digest.empty() || a.history.columns == b.history.columns) && differences(a, b).empty();
}

std::vector<std::size_t> once_each(const RunList& runs, const std::string& command, std::ostream& diagnostics) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto same = std::ranges::find_if(kept, [&](std::size_t k) { return is_same_run(*runs[i], *runs[k]); });
        if (same == kept.end()) {
            kept.push_back(i);
            continue;
        }
        std::size_t left_out = i;
        if (runs[i]->header.steps > runs[*same]->header.steps) std::swap(*same, left_out);
        say(diagnostics, fmt::format("{}: {} is the same test of the same specimen as {}, and counts once", command,
                                     printable(runs[left_out]->name), printable(runs[*same]->name)));
    }
    return kept;
}

std::vector<RunData> read_once_each(const std::vector<std::string>& paths, const std::string& command,
                                    std::ostream& diagnostics) {
    std::vector<RunData> runs = read_runs(paths);
    std::vector<RunData> kept;
    for (const std::size_t i : once_each(list_of(runs), command, diagnostics)) kept.push_back(std::move(runs[i]));
    return kept;
}

}  // namespace graincrack
