#include "post/calibrate/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <variant>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack::calibrate {

namespace {

constexpr Quantity specimens{"specimens", Dimension::one, 1, 50, "number of specimens"};
constexpr Quantity discs{"discs", Dimension::one, 1, 9, "number of discs at a point"};
constexpr Quantity points{"points", Dimension::one, 4, 99, "number of points of a design"};
constexpr Quantity designs{"designs", Dimension::one, 0, 3, "number of designs"};
constexpr Quantity corrections{"corrections", Dimension::one, 0, 9, "number of corrections"};
constexpr Quantity grains{"grains", Dimension::one, 2, 1e7, "number of grains of a specimen"};
constexpr Quantity share{"share", Dimension::one, 0.05, 0.95, "share of tests"};

/// A key of [study]: its quantity, and where its value goes, or its values.
struct StudyKey {
    Quantity quantity;
    std::variant<double*, std::size_t*, std::optional<double>*, std::vector<double>*> to;
    bool is_of_grains = false;  ///< replaces the grain size of the material's fabric
};

std::map<std::string, StudyKey> study_keys(Study& study) {
    Specimens& made = study.specimens;
    return {{"width", {quantity::width, &made.width}},
            {"height", {quantity::height, &made.height}},
            {"diameter", {quantity::diameter, &made.diameter}},
            {"half_disc_diameter", {quantity::diameter, &made.bend_size}},
            {"grains", {grains, &made.grains, true}},
            {"disc_grains", {grains, &made.disc_grains, true}},
            {"mean_edge", {quantity::mean_edge, &made.edge, true}},
            {"max_strain", {quantity::max_strain, &study.max_strain}},
            {"rate_tolerance", {quantity::rate_tolerance, &study.rate_tolerance}},
            {"confining_pressure", {quantity::confining_pressure, &study.confining_pressure}},
            {"predicted_pressures", {quantity::confining_pressure, &study.predicted_pressures}},
            {"elastic_specimens", {specimens, &study.elastic}},
            {"points", {points, &study.points}},
            {"discs", {discs, &study.discs}},
            {"moves", {designs, &study.moves}},
            {"corrections", {corrections, &study.corrections}},
            {"zooms", {designs, &study.zooms}},
            {"confirmation_discs", {specimens, &study.confirmation_discs}},
            {"confirmation_rectangles", {specimens, &study.confirmation_rectangles}},
            {"predicted_specimens", {specimens, &study.predicted}},
            {"first_peak_share", {share, &study.first_peak_fraction}}};
}

/// Fowler, Noll & Vo's hash (FNV-1a) in 32 bits.
std::uint32_t digest(const std::string& text) {
    std::uint32_t hash = 2166136261U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash;
}

/// The values of a material that the solver reads. \param point values that replace some of them, and are named elsewhere
std::string made_of(const Material& m, const Point& point) {
    const Rock& r = m.rock;
    const bool has_process_zone =
        std::ranges::any_of(point, [](const auto& value) { return value.first == "ratios.process_zone"; });
    std::string text = fmt::format("{} {} {} {} {} {} {} {}", r.young_modulus, r.poisson_ratio, r.density, r.mode_i_toughness,
                                   r.mode_ii_toughness, r.tensile_strength, m.platen_friction_angle, m.law);
    for (const ContactParameter& row : all_contact_parameters()) {
        if (const auto& value = m.contact.*row.given) text += fmt::format(" {}={}", row.key(), *value);
        if (const auto& ratio = m.ratios.*row.given) text += fmt::format(" {}:{}", row.key(), *ratio);
    }
    if (m.ratios.fracture_energy || has_process_zone) text += fmt::format(" grain_size={}", m.grains.grain_size.value_or(0));
    std::string table;
    for (const FabricValue& value : fabric_values(m.fabric)) {
        if (value.table != table) text += fmt::format("\n[{}]\n", value.table);
        table = value.table;
        text +=
            value.key + " = " + (value.number ? fmt::format("{:.17g}\n", *value.number) : fmt::format("\"{}\"\n", value.word));
    }
    return text;
}

constexpr double mm = 1e3;
constexpr double beam_over_span = 1.1;

/// The options by which the mesher makes a specimen, and a name for it.
struct SpecimenOptions {
    std::string options;
    std::string name;

    /// An option with a number, which the name has behind a letter.
    void add(const char* option, const char* letter, const std::optional<double>& value, const char* unit = "", int digits = 6) {
        if (!value) return;
        options += fmt::format(" {} {:.{}g}{}", option, *value, digits, unit);
        name += fmt::format("{}{:.{}g}", letter, *value, digits);
    }
    void add_size(const Specimens& s, Loading loading) {
        if (s.grain_size) return add("--grain-size", "d", *s.grain_size * mm, "mm");
        if (s.edge) return add("--edge", "e", *s.edge * mm, "mm");
        const bool is_disc = loading == Loading::splitting;
        add("--grains", "g", is_disc ? s.disc_grains : loading == Loading::bending ? s.bend_grains() : s.grains, "", 7);
    }
    /// What [fabric] says of grains but for their size.
    void add_grains(const GrainFabric& said) {
        if (!said.tessellation.empty()) options += " --tessellation " + said.tessellation;
        if (said.tessellation != "delaunay") name += said.tessellation;
        constexpr double degrees = 180 / std::numbers::pi;
        const auto& angle = said.elongation_angle;
        add("--spread", "v", said.size_variation);
        add("--elements-per-crystal", "t", said.elements_per_crystal);
        add("--elongation", "l", said.elongation);
        add("--elongation-angle", "a", angle ? std::optional(*angle * degrees) : std::nullopt, "deg");
    }
    void add_fabric(const MaterialFabric& fabric) {
        const char* before = " --phases ";
        for (const auto& [phase, values] : fabric.phases) {
            options += fmt::format("{}{}={:.6g}", std::exchange(before, ","), phase, values.fraction);
            name += fmt::format("{}{:.3g}", phase.substr(0, 2), 100 * values.fraction);
        }
        add("--strength-modulus", "m", fabric.strength_modulus);
        const bool is_correlated = fabric.strength_modulus && fabric.strength_correlation > 0;
        if (is_correlated) add("--strength-correlation", "c", fabric.strength_correlation * mm, "mm");
    }
};

/// The shape of the specimens of a test.
SpecimenOptions shape_options(const Specimens& s, Loading loading) {
    if (loading == Loading::splitting) {
        return {fmt::format("disc --diameter {:.6g}mm", s.diameter * mm), fmt::format("disc{:.6g}", s.diameter * mm)};
    }
    if (loading == Loading::bending) {
        const ToughnessTest bend = s.bend();
        const std::string size =
            bend.method == "beam" ? fmt::format("--width {:.6g}mm --height", beam_over_span * bend.span * mm) : "--diameter";
        return {fmt::format("{} {} {:.6g}mm --slit {:.6g}mm", bend.method, size, bend.size * mm, bend.notch * mm),
                fmt::format("{}{:.6g}", bend.method, bend.size * mm)};
    }
    return {fmt::format("rectangle --width {:.6g}mm --height {:.6g}mm", s.width * mm, s.height * mm),
            fmt::format("rectangle{:.6g}x{:.6g}", s.width * mm, s.height * mm)};
}

/// Specimens of crystals that break have as many of them whatever their size: 300 in a rectangle, 270 in a disc, as in the study
/// whose ratios they have (share/studies/toughness/README.md).
void take_size_of_crystals(Specimens& made, double grain_size) {
    made.width = rounded(34.0 / 3 * grain_size, 2);
    made.height = 2 * made.width;
    made.diameter = rounded(17 * grain_size, 2);
}

}  // namespace

double Specimens::mean_edge() const {
    if (edge) return *edge;
    if (grain_size) return *grain_size * std::sqrt(std::numbers::pi / std::numbers::sqrt3);
    return std::sqrt(4 * width * height / (std::numbers::sqrt3 * grains));
}

ToughnessTest Specimens::bend() const {
    const ToughnessTest made = of_laboratory.value_or(usual_half_disc(diameter));
    const double scale = bend_size.value_or(made.size) / made.size;
    return {made.method, scale * made.size, scale * made.notch, scale * made.span};
}

double Specimens::bend_grains() const {
    const ToughnessTest made = bend();
    const double area =
        made.method == "beam" ? beam_over_span * made.span * made.size : std::numbers::pi / 8 * made.size * made.size;
    return std::max(2.0, std::round(area / (std::numbers::pi / 4 * diameter * diameter) * disc_grains));
}

std::vector<Test> tests_of(const std::vector<Target>& targets) {
    std::vector<Test> tests;
    for (const Target& target : targets) {
        const auto same = std::ranges::find_if(tests, [&](const Test& t) { return t.has(target); });
        if (same == tests.end()) {
            tests.push_back({target.test(), target.confining_pressure, target.property.peak_drop});
        } else {
            same->peak_drop = std::max(same->peak_drop, target.property.peak_drop);
        }
    }
    const auto length = [](const Test& t) {
        return t.loading() == Loading::compression ? t.confining_pressure : -static_cast<double>(t.loading());
    };
    std::ranges::stable_sort(tests, [&](const Test& a, const Test& b) { return length(a) > length(b); });
    return tests;
}

Study read_study(const Material& rock, const TomlFile& file, const std::vector<std::string>& settings) {
    Study study;
    if (rock.toughness_test.is_known()) study.specimens.of_laboratory = rock.toughness_test;
    study.specimens.grain_size = rock.grains.grain_size;
    if (rock.grains.tessellation == "trigon" && rock.grains.grain_size) {
        take_size_of_crystals(study.specimens, *rock.grains.grain_size);
    }
    // 1.5 % for Augig granite (UCS 122 MPa, E 25.8 GPa), for other rocks in proportion to the strain UCS/E.
    const auto ucs = rock.laboratory_value("compressive_strength");
    const auto e = rock.laboratory_value("young_modulus");
    if (ucs && e) study.max_strain = rounded(0.015 * (*ucs / *e) / (122e6 / 25.8e9), 2);
    const auto keys = study_keys(study);
    const auto known_key = [&](const std::string& name, const std::string& where) -> const StudyKey& {
        const auto key = keys.find(name);
        if (key != keys.end()) return key->second;
        std::vector<std::string> known;
        for (const auto& each : keys) known.push_back(each.first);
        throw UsageError(
            fmt::format("{}: unknown key{}; known are {}", where, did_you_mean(name, known), fmt::join(known, ", ")));
    };
    const auto set = [&](const StudyKey& key, const std::vector<std::string>& texts, const std::string& where) {
        auto* const* const several = std::get_if<std::vector<double>*>(&key.to);
        if (texts.empty() || (texts.size() > 1 && several == nullptr)) throw UsageError(where + ": one value is needed");
        std::vector<double> values;
        for (const std::string& text : texts) values.push_back(parse_quantity(text, key.quantity, where));
        if (several != nullptr) **several = values;
        if (auto* const* const to = std::get_if<double*>(&key.to)) **to = values[0];
        if (auto* const* const to = std::get_if<std::size_t*>(&key.to)) **to = static_cast<std::size_t>(values[0]);
        if (auto* const* const to = std::get_if<std::optional<double>*>(&key.to)) **to = values[0];
        if (key.is_of_grains) study.specimens.grain_size.reset();
    };
    for (const TomlEntry& entry : file.entries) {
        if (entry.section != std::vector<std::string>{"study"}) continue;
        const std::string where = fmt::format("{}: line {}: study.{}", file.file, entry.line, entry.key);
        std::vector<std::string> texts;
        for (const TomlValue& value : entry.values) texts.push_back(value.text);
        try {
            set(known_key(entry.key, where), texts, where);
        } catch (const UsageError& error) {
            throw InputError(error.what());
        }
    }
    for (const std::string& setting : settings) {
        const auto [key, values] = key_and_value(setting, "--set", "KEY=VALUE");
        const std::string where = "--set " + setting;
        const auto texts = split(values, ',');
        set(known_key(key, where), {texts.begin(), texts.end()}, where);
    }
    return study;
}

RunRow row_of(const Material& rock, const Study& study, const RequestedRun& run) {
    const Specimens& s = study.specimens;
    const TestDescription& test = test_named(run.test.name);
    SpecimenOptions specimen = shape_options(s, test.loading);
    specimen.add_size(s, test.loading);
    specimen.add_grains(rock.grains);
    specimen.add_fabric(rock.fabric);
    RunRow row;
    row.mesh = fmt::format("{} --seed {}", specimen.options, run.seed);
    row.specimen = fmt::format("{}-s{}", specimen.name, run.seed);
    for (const auto& [key, value] : settings_of(run.point)) {
        row.material += fmt::format("{}--set {}={}", row.material.empty() ? "" : " ", key, value);
    }
    row.solve = run.test.name;
    if (test.is_confined) row.solve += " --confining-pressure " + pressure_text(run.test.confining_pressure);
    if (test.loading == Loading::bending) row.solve += fmt::format(" --span {:.6g}mm", s.bend().span * 1e3);
    // As the Brazilian test, with which they are compared.
    if (test.is_tensile() && test.plane != PlaneCondition::stress) row.solve += " --plane stress";
    if (test.loading == Loading::compression) {
        row.solve +=
            fmt::format(" --max-strain {:.5g} --peak-drop {} --rate-tolerance {:.6g}", run.max_strain.value_or(study.max_strain),
                        run.test.peak_drop < 1 ? fmt::format("{:g}", run.test.peak_drop) : "none", study.rate_tolerance);
    }
    row.file = fmt::format("{}_{}_{}_{:08x}.h5", run.test.label(), row.specimen, run.label,
                           digest(made_of(rock, run.point) + row.mesh + row.material + row.solve));
    return row;
}

}  // namespace graincrack::calibrate
