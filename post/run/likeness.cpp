#include "post/run/likeness.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>
#include <utility>

#include "post/run/test_label.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

// Options of the mesher whose values, as they were given, are traits of the specimen.
constexpr std::array shape_options{"pole", "flats", "inner-diameter"};
constexpr std::array cut_options{"hole", "holes", "slit", "slit-angle", "notch", "notch-angle", "flaws", "joint-set"};
constexpr std::array fabric_options{"size-distribution", "spread", "grade",         "elongation",       "elongation-angle",
                                    "elements-per-edge", "phases", "phase-cluster", "strength-modulus", "strength-correlation",
                                    "open-boundaries"};

std::string words_of(std::string name) {
    std::replace(name.begin(), name.end(), '-', ' ');
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

Trait number(Aspect aspect, const std::string& name, double value, Dimension dimension, double tolerance = 1e-9) {
    return {aspect, name, "", value, dimension, tolerance, 0, false, aspect == Aspect::material ? "material" : ""};
}

/// True if a value of a class of contacts is of the specimen and not of the material: the stiffness within crystals is as large
/// as the length of the contacts there wants.
bool is_of_specimen(const std::string& class_name, const ContactParameter& row) {
    const bool is_stiffness =
        row.value == &ContactParameters::normal_stiffness || row.value == &ContactParameters::shear_stiffness;
    return is_stiffness && !phase_of_within_class(class_name).empty();
}

void add_contact(std::vector<Trait>& traits, const ContactParameters& contact, const std::string& class_name) {
    for (const ContactParameter& row : all_contact_parameters()) {
        if (is_of_specimen(class_name, row)) continue;
        Trait& trait = traits.emplace_back(
            number(Aspect::material, words_of(std::string(row.quantity.name)), contact.*row.value, row.quantity.dimension));
        trait.follows_plane = row.follows_plane;
        if (class_name.empty()) continue;
        trait.follows = trait.name;
        trait.name += " of " + class_name;
    }
}

/// Holes and cracks that no option tells, as of a specimen that was imported.
std::string cuts_of(const RunData& run) {
    const SpecimenSummary& s = run.specimen;
    for (const char* key : cut_options) {
        if (s.options.count(key) > 0) return "";
    }
    std::vector<std::string> cuts;
    if (s.holes > 0) cuts.push_back(counted(s.holes, "hole"));
    if (s.is_cracked) cuts.emplace_back("cracks");
    const RunHeader& h = run.header;
    for (std::size_t k = n_contact_classes(h.fabric.phases.size()); k < h.class_names.size(); ++k) {
        if (phase_of_within_class(h.class_names[k]).empty()) cuts.push_back(h.class_names[k]);
    }
    return fmt::format("{}", fmt::join(cuts, " and "));
}

bool is_round(const SpecimenSummary& s) { return s.shape == "disc" || s.shape == "ring" || s.shape == "half-disc"; }

void add_shape(std::vector<Trait>& traits, const RunData& run) {
    constexpr double same_length = 1e-6;
    const SpecimenSummary& s = run.specimen;
    traits.push_back({Aspect::shape, "shape", s.shape});
    traits.push_back(number(Aspect::size, is_round(s) ? "diameter" : "width", s.width, Dimension::length, same_length));
    if (!is_round(s)) traits.push_back(number(Aspect::size, "height", s.height, Dimension::length, same_length));
    traits.push_back(number(Aspect::size, "span", run.header.span, Dimension::length, same_length));
    traits.push_back({Aspect::cuts, "cut", cuts_of(run)});
}

/// The minerals with their fractions of the area, which are reached to single grains.
void add_minerals(std::vector<Trait>& traits, const SpecimenSummary& s) {
    std::vector<std::string> names;
    for (const auto& [name, fraction] : s.phases) names.push_back(name);
    const std::string text = fmt::format("{}", fmt::join(names, " "));
    traits.push_back({.aspect = Aspect::material, .name = "minerals", .text = text, .follows = "material"});
    for (const auto& [name, fraction] : s.phases) {
        Trait& trait = traits.emplace_back(number(Aspect::material, name, fraction, Dimension::one));
        trait.slack = 0.03 + 2 / static_cast<double>(std::max<std::int64_t>(1, s.crystals));
        trait.follows = "minerals";
    }
}

void add_grains(std::vector<Trait>& traits, const SpecimenSummary& s) {
    constexpr double of_draws = 0.05, of_elements = 0.1, of_rims = 0.03;
    traits.push_back(number(Aspect::grain_size, "grain diameter", s.grain_diameter, Dimension::length, of_draws));
    traits.push_back({Aspect::fabric, "tessellation", s.tessellation});
    traits.push_back(number(Aspect::fabric, "elements a crystal", s.elements_per_crystal, Dimension::one, of_elements));
    const auto given = [&](const std::string& key) {
        const auto found = s.options.find(key);
        return found == s.options.end() ? "" : found->second;
    };
    for (const char* key : shape_options) traits.push_back({Aspect::shape, words_of(key), given(key)});
    for (const char* key : fabric_options) traits.push_back({Aspect::fabric, words_of(key), given(key)});
    const bool is_scattered = s.has_strength_factors && given("strength-modulus").empty();
    traits.push_back({Aspect::fabric, "scatter of strengths", is_scattered ? "that of the material" : ""});
    // The same grains, loaded along another diameter, are others as a seed makes them, unless they have a direction.
    bool is_directed = !given("elongation").empty() && given("elongation") != "1";
    for (const char* key : cut_options) {
        traits.push_back({Aspect::cuts, words_of(key), given(key)});
        is_directed = is_directed || !given(key).empty();
    }
    traits.push_back({Aspect::cuts, "loaded diameter", is_directed ? given("loaded-diameter") : ""});
    traits.push_back(number(Aspect::size, "area", s.area, Dimension::area, of_rims));
    traits.back().follows = is_round(s) ? "diameter" : "width";
}

void add_loading(std::vector<Trait>& traits, const RunData& run) {
    const RunHeader& h = run.header;
    const bool is_automatic = h.rate == "auto";  // its platen speed is a result
    traits.push_back({Aspect::loading, "rate", h.rate});
    traits.push_back(number(Aspect::rate, "rate tolerance", h.rate_tolerance, Dimension::one));
    traits.push_back(number(Aspect::rate, "rate share", h.rate_share, Dimension::one));
    traits.push_back(number(Aspect::rate, "platen speed", is_automatic ? 0 : h.platen_speed, Dimension::speed));
    traits.push_back(number(Aspect::loading, "damping", h.damping, Dimension::one));
    traits.push_back({Aspect::loading, "damping form", h.damping_form});
    traits.push_back({Aspect::loading, "mass scaling", h.mass_scaling});
    traits.push_back(number(Aspect::loading, "platen friction", h.platen_friction, Dimension::angle));
    traits.push_back({Aspect::loading, "program", run.program});
    traits.push_back(number(Aspect::end, "peak drop", h.peak_drop, Dimension::one));
}

/// Whether two values are the same, but for what draws make of one.
bool is_same(const Trait& a, const Trait& b) {
    if (!a.number || !b.number) return a.text == b.text && a.number.has_value() == b.number.has_value();
    const double size = std::max(std::abs(*a.number), std::abs(*b.number));
    return std::abs(*a.number - *b.number) <= std::max({a.tolerance * size, a.slack, b.slack});
}

/// "30 mm"; "none" for what a run does not have.
std::string value_of(const Trait& trait, int digits) {
    constexpr std::size_t most = 60;  // characters of a text
    if (!trait.number) return trait.text.empty() ? "none" : trait.text.substr(0, most);
    return format_quantity(*trait.number, trait.dimension, trait.tolerance > 1e-3 ? std::min(digits, 2) : digits);
}

/// The same with as many digits as tell it from another.
std::string value_beside(const Trait& trait, const Trait& other) {
    const std::string value = value_of(trait, 4);
    return value == value_of(other, 4) ? value_of(trait, 10) : value;
}

const Trait* find(const std::vector<Trait>& traits, std::size_t near, const std::string& name) {
    if (near < traits.size() && traits[near].name == name) return &traits[near];
    const auto found = std::find_if(traits.begin(), traits.end(), [&](const Trait& t) { return t.name == name; });
    return found == traits.end() ? nullptr : &*found;
}

/// The traits in which two runs differ, of both. What only one of them has needs no comparison: other traits tell it.
std::vector<std::pair<const Trait*, const Trait*>> differing(const std::vector<Trait>& a, const std::vector<Trait>& b,
                                                             const Aspects& except) {
    const Trait* const plane = find(a, 0, "plane");
    const Trait* const other_plane = find(b, 0, "plane");
    std::vector<std::pair<const Trait*, const Trait*>> pairs;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (except.count(a[i].aspect) > 0 || (a[i].follows_plane && plane->text != other_plane->text)) continue;
        const Trait* const other = find(b, i, a[i].name);
        if (other != nullptr && !is_same(a[i], *other)) pairs.emplace_back(&a[i], other);
    }
    return pairs;
}

std::vector<std::vector<Trait>> all_traits(const RunList& runs) {
    std::vector<std::vector<Trait>> all;
    for (const RunData* run : runs) all.push_back(traits_of(*run));
    return all;
}

/// Whether a trait is to be told beside those told before, which has to be: what it follows is the same.
bool tell(std::set<std::string>& told, const Trait& trait) {
    told.insert(trait.name);
    return told.count(trait.follows) == 0;
}

/// The order of tables: Brazilian, tension and bending, compression by rising pressure, then test, shape and size of the grains.
std::tuple<int, double, std::string, std::string, double> table_order(const RunData& run) {
    constexpr double size_unit = 1e-4;  // m: draws do not decide
    const RunHeader& h = run.header;
    const int order = h.loading() == Loading::splitting ? 0 : h.loading() == Loading::compression ? 2 : 1;
    return {order, h.confining_pressure, h.test, distinct_shape(run), std::round(run.specimen.grain_diameter / size_unit)};
}

}  // namespace

std::vector<Trait> material_traits(const RunSettings& header) {
    std::vector<Trait> traits{
        {Aspect::plane, "plane", std::string(name_of(header.plane))},
        {Aspect::material, "material", header.material},
        {.aspect = Aspect::material, .name = "contact law", .text = header.contact_law, .follows = "material"},
        {.aspect = Aspect::material,
         .name = "choice of the fracture energy",
         .text = header.fracture_energy_choice,
         .follows = "material"}};
    const auto add_rock = [&](const Phase& phase, const std::string& whose) {
        for (Trait trait : {number(Aspect::material, "E", phase.young_modulus, Dimension::stress),
                            number(Aspect::material, "ν", phase.poisson_ratio, Dimension::one),
                            number(Aspect::material, "density", phase.density, Dimension::density)}) {
            if (!whose.empty()) trait.follows = trait.name;
            trait.name += whose;
            traits.push_back(std::move(trait));
        }
    };
    add_rock(phase_of(header.rock), "");
    add_contact(traits, header.contact, "");
    const auto class_name = [&](std::size_t k) {
        return k < header.class_names.size() ? header.class_names[k] : fmt::format("class {}", k);
    };
    for (std::size_t p = 0; p < header.fabric.phases.size(); ++p) {
        const std::string pair = class_name(contact_class(p, p));  // "quartz-quartz"
        add_rock(header.fabric.phases[p], " of " + pair.substr(0, pair.size() / 2));
    }
    for (std::size_t k = 0; k < header.fabric.contacts.size(); ++k) add_contact(traits, header.fabric.contacts[k], class_name(k));
    return traits;
}

std::vector<Trait> traits_of(const RunData& run) {
    std::vector<Trait> traits = material_traits(run.header);
    traits.insert(traits.begin() + 1,
                  {{Aspect::test, "test", run.header.test},
                   number(Aspect::pressure, "confining pressure", run.header.confining_pressure, Dimension::stress)});
    traits.push_back({Aspect::heat, "heat", run.header.heat_label()});
    add_minerals(traits, run.specimen);
    add_shape(traits, run);
    add_grains(traits, run.specimen);
    add_loading(traits, run);
    return traits;
}

std::string differences(const std::vector<Trait>& a, const std::vector<Trait>& b, const Aspects& except) {
    constexpr std::size_t most = 5;
    std::vector<std::string> list;
    std::set<std::string> told;
    for (const auto& [one, other] : differing(a, b, except)) {
        if (!tell(told, *one)) continue;
        list.push_back(fmt::format("{} ({}, {})", one->name, value_beside(*one, *other), value_beside(*other, *one)));
    }
    const std::size_t more = list.size() > most ? list.size() - most : 0;
    list.resize(list.size() - more);
    return fmt::format("{}", fmt::join(list, ", ")) + (more > 0 ? fmt::format(" and {} more", more) : "");
}

std::string differences(const RunData& a, const RunData& b, const Aspects& except) {
    return differences(traits_of(a), traits_of(b), except);
}

RunList list_of(const std::vector<RunData>& runs) {
    RunList list;
    for (const RunData& run : runs) list.push_back(&run);
    return list;
}

std::vector<std::string> distinctions(const RunList& runs, const Aspects& except) {
    const auto traits = all_traits(runs);
    Aspects untold = except;
    untold.insert({Aspect::test, Aspect::pressure});
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        std::map<std::string, std::string> told;
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const bool is_one_test = except.count(Aspect::test) > 0 || series_label(*runs[i]) == series_label(*runs[k]);
            if (!is_one_test) continue;
            std::set<std::string> seen;
            for (const auto& [own, other] : differing(traits[i], traits[k], untold)) {
                const std::string value = value_beside(*own, *other);
                if (!tell(seen, *own) || value == "none") continue;
                told[own->name] = own->name == "material" || own->name == "heat" ? value : own->name + " " + value;
            }
        }
        std::vector<std::string> list;
        for (const Trait& trait : traits[i]) {
            if (told.count(trait.name) > 0) list.push_back(told[trait.name]);
        }
        texts.push_back(fmt::format("{}", fmt::join(list, ", ")));
    }
    return texts;
}

std::vector<LikeGroup> groups_of_like(const RunList& runs, const Aspects& except, const Aspects& untold) {
    const auto traits = all_traits(runs);
    std::vector<LikeGroup> groups;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        LikeGroup own{{i}, ""};
        const auto holds = [&](const LikeGroup& group) {
            return std::any_of(group.runs.begin(), group.runs.end(),
                               [&](std::size_t k) { return differing(traits[i], traits[k], except).empty(); });
        };
        // A run that is like two groups makes them one, so that the order of the runs does not matter.
        for (const LikeGroup& group : groups) {
            if (holds(group)) own.runs.insert(own.runs.end(), group.runs.begin(), group.runs.end());
        }
        groups.erase(std::remove_if(groups.begin(), groups.end(), holds), groups.end());
        std::sort(own.runs.begin(), own.runs.end());
        groups.push_back(std::move(own));
    }
    const auto order = [&](const LikeGroup& group) { return std::pair(table_order(*runs[group.runs[0]]), group.runs[0]); };
    std::sort(groups.begin(), groups.end(), [&](const LikeGroup& a, const LikeGroup& b) { return order(a) < order(b); });
    RunList firsts;
    for (const LikeGroup& group : groups) firsts.push_back(runs[group.runs[0]]);
    Aspects all = except;
    all.insert(untold.begin(), untold.end());
    const std::vector<std::string> told = distinctions(firsts, all);
    for (std::size_t g = 0; g < groups.size(); ++g) groups[g].distinction = told[g];
    return groups;
}

std::string common_material(const std::vector<RunData>& runs, const std::string& otherwise) {
    const std::string& name = runs.front().header.material;
    const bool is_common = std::all_of(runs.begin(), runs.end(), [&](const RunData& run) { return run.header.material == name; });
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

void require_alike(const std::vector<RunData>& runs, const std::string& what, const Aspects& except) {
    std::map<std::tuple<std::string, double, std::string>, const RunData*> tests;
    Aspects of_others = of_the_test;
    of_others.insert(except.begin(), except.end());
    for (const RunData& run : runs) {
        const RunHeader& h = run.header;
        const auto [test, is_first] = tests.try_emplace({h.test, h.confining_pressure, distinct_shape(run)}, &run);
        const RunData& other = is_first ? runs.front() : *test->second;
        const std::string found = differences(run, other, is_first ? of_others : except);
        if (found.empty()) continue;
        const std::string others = except.empty() ? "one kind that differ in their seeds only" : "one kind otherwise";
        throw InputError(run.name + ": differs from " + other.name + " in " + found + "; " + what + " needs tests of " +
                         (is_first ? "one material and fabric" : others));
    }
}

bool is_same_run(const RunData& a, const RunData& b) {
    return a.specimen.seed == b.specimen.seed && a.specimen_digest == b.specimen_digest &&
           (!a.specimen_digest.empty() || a.history.columns == b.history.columns) && differences(a, b, {Aspect::end}).empty();
}

std::vector<std::size_t> once_each(const RunList& runs, const std::string& command, std::ostream& diagnostics) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto same = std::find_if(kept.begin(), kept.end(), [&](std::size_t k) { return is_same_run(*runs[i], *runs[k]); });
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
