#include "post/calibrate/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>

#include "post/table/output_file.hpp"
#include "post/table/table_file.hpp"
#include "share/error.hpp"
#include "share/toml_file.hpp"
#include "share/units.hpp"

namespace graincrack::calibrate {

namespace {

namespace fs = std::filesystem;

constexpr Quantity specimens{"specimens", Dimension::one, 1, 10000, "number of specimens"};
constexpr Quantity rounds{"rounds", Dimension::one, 1, 100, "rounds of fit and confirmation"};

/// A key of [study]: its quantity, and where its values go.
struct StudyKey {
    Quantity quantity;
    std::function<void(const std::vector<double>&)> set;
    bool several = false;
};

std::map<std::string, StudyKey> study_keys(Study& study) {
    const auto number = [](double& to) { return [&to](const std::vector<double>& v) { to = v[0]; }; };
    const auto count = [](std::size_t& to) {
        return [&to](const std::vector<double>& v) { to = static_cast<std::size_t>(v[0]); };
    };
    return {
        {"mean_edge", {quantity::mean_edge, number(study.mean_edge)}},
        {"max_strain", {quantity::max_strain, number(study.max_strain)}},
        {"confining_pressure", {quantity::confining_pressure, number(study.targets.confining_pressure)}},
        {"predicted_pressures",
         {quantity::confining_pressure, [&study](const std::vector<double>& v) { study.targets.predicted_pressures = v; }, true}},
        {"elastic_specimens", {specimens, count(study.elastic)}},
        {"scan_discs", {specimens, count(study.scan_discs)}},
        {"discs", {specimens, count(study.discs.least)}},
        {"max_discs", {specimens, count(study.discs.most)}},
        {"rectangles", {specimens, count(study.rectangles.least)}},
        {"max_rectangles", {specimens, count(study.rectangles.most)}},
        {"centre_runs", {specimens, count(study.centre_runs)}},
        {"rounds", {rounds, count(study.rounds)}}};
}

void remove_file(const fs::path& file) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw OutputError(fmt::format("{}: cannot be removed: {}", file.string(), error.message()));
}

std::string si_text(double value, double si, const std::string& unit) {
    return unit.empty() ? fmt::format("{:.7g}", value / si) : fmt::format("\"{:.7g} {}\"", value / si, unit);
}

std::string with_interval(const Estimate& e, double si) {
    if (!e.low || !e.high) return fmt::format("{:.5g}", e.value / si);
    return fmt::format("{:.5g} ({:.5g} to {:.5g})", e.value / si, *e.low / si, *e.high / si);
}

std::string markdown_row(const std::vector<std::string>& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }
std::string markdown_head(const std::vector<std::string>& cells) {
    std::string rule = "|";
    for (std::size_t i = 0; i < cells.size(); ++i) rule += "---|";
    return "\n" + markdown_row(cells) + rule + "\n";
}

/// Moduli by file: E, ν, and both predicted.
std::map<std::string, std::array<double, 4>> read_moduli(const std::string& path) {
    const TableFile table(path);
    const std::vector<std::string> files = table.texts("file");
    std::array<std::vector<double>, 4> columns;
    const std::array<const char*, 4> names{"young_modulus_GPa", "poisson_ratio", "predicted_young_modulus_GPa",
                                           "predicted_poisson_ratio"};
    for (std::size_t i = 0; i < 4; ++i) columns[i] = table.numbers_or_nan(names[i]);
    std::map<std::string, std::array<double, 4>> out;
    for (std::size_t row = 0; row < files.size(); ++row)
        out[files[row]] = {columns[0][row] * 1e9, columns[1][row], columns[2][row] * 1e9, columns[3][row]};
    return out;
}

std::string contact_text(const Material& at, const Point& point) {
    std::string text = "\n[contact]\n";
    for (const ParameterRow& row : parameters()) {
        const std::string key = row.key;
        if (!key.starts_with("contact.") || !point[row.parameter]) continue;
        const std::string unit = row.parameter == Parameter::friction_angle    ? "deg"
                                 : row.parameter == Parameter::fracture_energy ? "J/m2"
                                                                               : row.unit;
        text += fmt::format("{} = {}\n", key.substr(8), si_text(*point[row.parameter], row.si, unit));
    }
    const auto other = [&](const char* key, const std::optional<double>& value, const std::string& unit) {
        if (value) text += fmt::format("{} = {}\n", key, si_text(*value, 1, unit));
    };
    other("normal_stiffness", at.contact.normal_stiffness, "");
    other("shear_stiffness", at.contact.shear_stiffness, "");
    if (!point[Parameter::fracture_energy]) other("fracture_energy", at.contact.fracture_energy, "");
    if (!point[Parameter::open_shear_strength]) other("open_shear_strength", at.contact.open_shear_strength, "");
    other("mode_ii_fracture_energy", at.contact.mode_ii_fracture_energy, "");
    other("residual_tensile_strength", at.contact.residual_tensile_strength, "");
    other("residual_cohesion", at.contact.residual_cohesion, "");
    other("residual_friction_angle", at.contact.residual_friction_angle, "");
    return text;
}

std::string outcomes_text(const Decision& decision) {
    std::string text =
        markdown_head({"target", "asked", "laboratory", "new specimens", "number", "off", "bound", "verdict", "note"});
    for (const Outcome& o : decision.outcomes) {
        const Target& t = o.target;
        const std::string unit = t.unit.empty() ? "" : ", " + t.unit;
        std::string off;
        if (o.ours)
            off = t.absolute ? fmt::format("{:+.4f}", o.ours->value - t.value)
                             : fmt::format("{:+.2f} %", 100 * (o.ours->value / t.value - 1));
        text += markdown_row(
            {t.symbol + unit, t.role == Role::fitted ? "fitted" : "predicted", fmt::format("{:.5g}", t.value / t.si),
             o.ours ? with_interval(*o.ours, t.si) : "", std::to_string(o.specimens), off,
             t.absolute ? fmt::format("± {:g}", t.bound) : fmt::format("± {:g} %", 100 * t.bound), o.verdict, o.note});
    }
    return text;
}

}  // namespace

Study read_study(const Material& rock) {
    Study study;
    // 1.5 % for Augig granite (UCS 122 MPa, E 25.8 GPa), for other rocks in proportion to the strain UCS/E.
    const auto ucs = rock.laboratory.find("compressive_strength");
    const auto e = rock.laboratory.find("young_modulus");
    if (ucs != rock.laboratory.end() && e != rock.laboratory.end())
        study.max_strain = std::stod(fmt::format("{:.2g}", 0.015 * (ucs->second / e->second) / (122e6 / 25.8e9)));
    auto keys = study_keys(study);
    const TomlFile toml = read_toml(rock.file.string());
    for (const TomlEntry& entry : toml.entries) {
        if (entry.section != std::vector<std::string>{"study"}) continue;
        const std::string where = fmt::format("{}: line {}: study.{}", toml.file, entry.line, entry.key);
        const auto key = keys.find(entry.key);
        if (key == keys.end()) {
            std::vector<std::string> known;
            for (const auto& [name, each] : keys) known.push_back(name);
            throw InputError(fmt::format("{}: unknown key; known are {}", where, fmt::join(known, ", ")));
        }
        if (entry.values.empty() || (entry.is_array && !key->second.several))
            throw InputError(where + ": one value is needed, not an array");
        std::vector<double> values;
        try {
            for (const TomlValue& value : entry.values) values.push_back(parse_quantity(value.text, key->second.quantity, where));
        } catch (const UsageError& error) {
            throw InputError(error.what());
        }
        key->second.set(values);
    }
    return study;
}

std::vector<FinishedRun> read_finished(const std::string& strength, const std::string& moduli) {
    const TableFile table(strength);
    const auto files = table.texts("file");
    const auto tests = table.texts("test");
    const auto kinds = table.texts("peak_kind");
    const auto seeds = table.numbers("seed");
    const auto pressures = table.numbers("confining_pressure_MPa");
    const auto limits = table.numbers("max_strain");
    const auto edges = table.numbers("mean_edge_mm");
    const auto compressive = table.numbers_or_nan("peak_compressive_stress_MPa");
    const auto tensile = table.numbers_or_nan("tensile_strength_MPa");
    std::array<std::vector<double>, n_parameters> values;
    for (std::size_t i = 0; i < n_parameters; ++i) values[i] = table.numbers(parameters()[i].column);
    std::map<std::string, std::array<double, 4>> moduli_of;
    if (std::find(tests.begin(), tests.end(), "uniaxial") != tests.end()) moduli_of = read_moduli(moduli);
    std::vector<FinishedRun> runs;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        FinishedRun run;
        run.test = tests[row];
        run.confining_pressure = pressures[row] * 1e6;
        run.seed = static_cast<std::int64_t>(seeds[row]);
        for (std::size_t i = 0; i < n_parameters; ++i) run.values[i] = values[i][row] * parameters()[i].si;
        run.max_strain = limits[row];
        run.mean_edge = edges[row] * 1e-3;
        run.strength = (std::isnan(tensile[row]) ? compressive[row] : tensile[row]) * 1e6;
        run.has_peak = kinds[row] == "drop";
        const auto found = moduli_of.find(files[row]);
        if (found != moduli_of.end()) {
            const std::array<std::optional<double>*, 4> to{&run.young_modulus, &run.poisson_ratio, &run.predicted_young_modulus,
                                                           &run.predicted_poisson_ratio};
            for (std::size_t i = 0; i < 4; ++i) {
                if (!std::isnan(found->second[i])) *to[i] = found->second[i];
            }
        }
        if (!std::isnan(run.strength)) runs.push_back(run);
    }
    return runs;
}

std::string grains_file(const Point& point) {
    return fmt::format("grains-E{:.6g}-nu{:.6g}.toml", point[Parameter::young_modulus].value() * 1e-9,
                       point[Parameter::poisson_ratio].value());
}

std::string wanted_table(const std::vector<WantedRun>& wanted) {
    std::string text = "test\tconfining_pressure_MPa\tseed\tmaterial";
    for (const ParameterRow& row : parameters()) {
        if (std::string(row.key).starts_with("contact.")) text += fmt::format("\t{}", row.column);
    }
    text += "\tmax_strain\treason\n";
    for (const WantedRun& run : wanted) {
        text += fmt::format("{}\t{:.7g}\t{}\t{}", run.test, run.confining_pressure * 1e-6, run.seed, grains_file(run.point));
        for (const ParameterRow& row : parameters()) {
            if (!std::string(row.key).starts_with("contact.")) continue;
            text += run.point[row.parameter] ? fmt::format("\t{:.6g}", *run.point[row.parameter] / row.si) : "\t";
        }
        text += fmt::format("\t{}\t{}\n", run.max_strain ? fmt::format("{:.5g}", *run.max_strain) : "", run.reason);
    }
    return text;
}

std::string material_text(const Material& rock, const Point& point, const Decision* fitted) {
    const Material at = material_at(rock, point);
    std::string text = fmt::format("name = \"{}, {}\"\n\n[rock]\n", rock.name, fitted ? "calibrated" : "grains");
    text += fmt::format(
        "young_modulus = {}\npoisson_ratio = {:.7g}\ndensity = {}\nmode_i_toughness = {}\nmode_ii_toughness = {}\n"
        "tensile_strength = {}\n",
        si_text(at.rock.young_modulus, 1e9, "GPa"), at.rock.poisson_ratio, si_text(at.rock.density, 1, "kg/m3"),
        si_text(at.rock.mode_i_toughness, 1e6, "MPa.m^0.5"), si_text(at.rock.mode_ii_toughness, 1e6, "MPa.m^0.5"),
        si_text(at.rock.tensile_strength, 1e6, "MPa"));
    text += contact_text(at, point);
    text += fmt::format("\n[platen]\nfriction_angle = {:.9g}\n\n[laboratory]\n", at.platen_friction_angle);
    for (const auto& [key, value] : rock.laboratory) text += fmt::format("{} = {:.9g}\n", key, value);
    if (fitted == nullptr) return text;
    text += "\n[fitted]  # property: what it was fitted to, and what new specimens have\n";
    for (const Outcome& o : fitted->outcomes) {
        if (o.target.role != Role::fitted || !o.ours) continue;
        text += fmt::format("{} = \"{:.5g} {}: {} on {} new specimens\"\n", o.target.name, o.target.value / o.target.si,
                            o.target.unit, with_interval(*o.ours, o.target.si), o.specimens);
    }
    return text;
}

std::string report_text(const Material& rock, const Study& study, const Decision& decision, std::size_t n_runs) {
    std::string text = fmt::format("# {}: {}\n\n{}.\n", rock.name, label_of(decision.ending), decision.reason);
    text += fmt::format(
        "\n{}: {}. {} runs. Discs: {}; rectangles: {}. At most {} rounds of fit and confirmation, each on new specimens.\n",
        decision.ending == Ending::calibrated ? "Calibrated point" : "Nearest point", label_of(decision.point), n_runs,
        label_of(study.discs), label_of(study.rectangles), study.rounds);
    if (!decision.outcomes.empty()) text += "\n## Targets\n" + outcomes_text(decision);
    text +=
        "\n## Values\n" + markdown_head({"parameter", "value with its 95 % interval", "unit", "moves", "first guess", "bounds"});
    for (const ParameterRow& row : parameters()) {
        if (!decision.point[row.parameter]) continue;
        const auto value = std::find_if(decision.values.begin(), decision.values.end(),
                                        [&](const Calibrated& c) { return c.parameter == row.parameter; });
        const Estimate here = value != decision.values.end() ? value->value : Estimate{*decision.point[row.parameter], {}, {}};
        text += markdown_row({row.symbol, with_interval(here, row.si), row.unit, row.moves, row.first_guess, row.range});
    }
    text += "\n## Steps\n" + markdown_head({"stage", "what", "result"});
    for (const Step& step : decision.steps) text += markdown_row({step.stage, step.what, step.result});
    return text;
}

Decision calibrate_folder(const std::string& folder) {
    const fs::path place(folder);
    const Material rock = read_material((place / "material.toml").string());
    const Study study = read_study(rock);
    const std::string strength = (place / "strength.tsv").string();
    std::vector<FinishedRun> finished;
    if (fs::exists(strength)) finished = read_finished(strength, (place / "moduli.tsv").string());
    Decision decision = decide(rock, study, finished);
    for (const char* name : {"wanted.tsv", "calibrated.toml", "report.md"}) remove_file(place / name);
    if (decision.ending == Ending::wanted) {
        std::set<std::string> written;
        for (const WantedRun& run : decision.wanted) {
            const std::string name = grains_file(run.point);
            if (written.insert(name).second) write_whole_file((place / name).string(), material_text(rock, run.point, nullptr));
        }
        write_whole_file((place / "wanted.tsv").string(), wanted_table(decision.wanted));
        return decision;
    }
    write_whole_file((place / "report.md").string(), report_text(rock, study, decision, finished.size()));
    if (decision.ending == Ending::calibrated)
        write_whole_file((place / "calibrated.toml").string(), material_text(rock, decision.point, &decision));
    return decision;
}

}  // namespace graincrack::calibrate
