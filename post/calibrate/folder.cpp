#include "post/calibrate/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <sstream>

#include "post/table/table_file.hpp"
#include "share/error.hpp"
#include "share/incomplete_material.hpp"
#include "share/output_file.hpp"
#include "share/toml_file.hpp"
#include "share/units.hpp"

namespace graincrack::calibrate {

namespace {

namespace fs = std::filesystem;

constexpr Quantity specimens{"specimens", Dimension::one, 1, 10000, "number of specimens"};
constexpr Quantity rounds{"rounds", Dimension::one, 1, 100, "rounds of fit and confirmation"};
constexpr Quantity grains{"grains", Dimension::one, 2, 1e7, "number of grains of a specimen"};

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
        {"width", {quantity::width, number(study.specimens.width)}},
        {"height", {quantity::height, number(study.specimens.height)}},
        {"diameter", {quantity::diameter, number(study.specimens.diameter)}},
        {"grains", {grains, number(study.specimens.grains)}},
        {"disc_grains", {grains, number(study.specimens.disc_grains)}},
        {"mean_edge", {quantity::mean_edge, [&study](const std::vector<double>& v) { study.specimens.edge = v[0]; }}},
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
        {"predicted_specimens", {specimens, count(study.predicted)}},
        {"rounds", {rounds, count(study.rounds)}}};
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

/// A column of `moduli` or `toughness`: where its values go, and its unit in SI.
struct Measure {
    const char* column;
    std::optional<double> FinishedRun::*to;
    double si;
};
constexpr std::array moduli_measures{Measure{"young_modulus_GPa", &FinishedRun::young_modulus, 1e9},
                                     Measure{"poisson_ratio", &FinishedRun::poisson_ratio, 1},
                                     Measure{"predicted_young_modulus_GPa", &FinishedRun::predicted_young_modulus, 1e9},
                                     Measure{"predicted_poisson_ratio", &FinishedRun::predicted_poisson_ratio, 1},
                                     Measure{"crack_initiation_count_MPa", &FinishedRun::crack_initiation, 1e6},
                                     Measure{"crack_damage_2d_MPa", &FinishedRun::crack_damage, 1e6}};
constexpr std::array toughness_measures{Measure{"mode_i_toughness_MPa.m^0.5", &FinishedRun::mode_i_toughness, 1e6}};

/// Adds the measures of a table to the runs of its files. \throws InputError if two of its rows say other values of one file
void add_measures(const std::string& path, std::span<const Measure> measures, const std::vector<std::string>& files,
                  std::vector<FinishedRun>& runs) {
    const TableFile table(path);
    const std::vector<std::string> rows = table.texts("file");
    std::map<std::string, std::size_t> row_of_file;
    for (std::size_t row = 0; row < rows.size(); ++row) row_of_file.try_emplace(rows[row], row);
    for (const Measure& measure : measures) {
        const std::vector<double> values = table.numbers_or_nan(measure.column);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            const double first = values[row_of_file[rows[row]]];
            if (values[row] == first || (std::isnan(values[row]) && std::isnan(first))) continue;
            throw InputError(fmt::format("{}: {} has {} = {:.7g} and {:.7g}: two runs of one name; each needs a name of its own",
                                         path, rows[row], measure.column, first, values[row]));
        }
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const auto row = row_of_file.find(files[i]);
            if (row != row_of_file.end() && !std::isnan(values[row->second]))
                runs[i].*measure.to = values[row->second] * measure.si;
        }
    }
}

/// The rock, of which [contact] may be missing: it is what a calibration finds.
Material read_rock(const std::string& name_or_file) {
    IncompleteMaterial rock = read_incomplete_material(name_or_file);
    std::erase_if(rock.missing, [](const std::string& key) { return key.starts_with("contact."); });
    if (rock.missing.empty()) return std::move(rock.material);
    throw InputError(fmt::format("{}: missing: {}; a calibration needs all of [rock]", rock.material.file.string(),
                                 fmt::join(rock.missing, ", ")));
}

/// [contact] at a point, of which `at` is the material: what a calibration may change in the units of its tables.
std::string contact_text(const Material& at, const Point& point) {
    std::string text = "\n[contact]\n";
    for (const ContactParameter& contact : all_contact_parameters()) {
        const std::optional<double>& value = at.contact.*contact.given;
        if (!value) continue;
        double si = 1;
        std::string unit;
        for (const ParameterRow& row : parameters()) {
            if (row.contact != &contact || !point[row.parameter]) continue;
            si = row.si;
            unit = unit_in_files(row);
        }
        text += fmt::format("{} = {}\n", contact.key(), si_text(*value, si, unit));
    }
    if (!at.law.empty()) text += fmt::format("law = \"{}\"\n", at.law);
    return text + fabric_text(at.fabric);
}

std::string outcomes_text(const Decision& decision) {
    std::string text =
        markdown_head({"target", "asked", "laboratory", "new specimens", "number", "off", "bound", "verdict", "note"});
    for (const Outcome& o : decision.outcomes) {
        const Target& t = o.target;
        const std::string unit = t.unit.empty() ? "" : ", " + t.unit;
        std::string off;
        const bool known = !std::isnan(t.value);
        if (o.ours && known)
            off = t.absolute ? fmt::format("{:+.4f}", o.ours->value - t.value)
                             : fmt::format("{:+.2f} %", 100 * (o.ours->value / t.value - 1));
        text += markdown_row({t.symbol + unit, t.role == Role::fitted ? "fitted" : "predicted",
                              known ? fmt::format("{:.5g}", t.value / t.si) : "", o.ours ? with_interval(*o.ours, t.si) : "",
                              std::to_string(o.specimens), off,
                              !known       ? ""
                              : t.absolute ? fmt::format("± {:g}", t.bound)
                                           : fmt::format("± {:g} %", 100 * t.bound),
                              o.verdict, o.note});
    }
    return text;
}

}  // namespace

Study read_study(const Material& rock, const std::vector<std::string>& settings) {
    Study study;
    // 1.5 % for Augig granite (UCS 122 MPa, E 25.8 GPa), for other rocks in proportion to the strain UCS/E.
    const auto ucs = rock.laboratory.find("compressive_strength");
    const auto e = rock.laboratory.find("young_modulus");
    if (ucs != rock.laboratory.end() && e != rock.laboratory.end())
        study.max_strain = graincrack::rounded(0.015 * (ucs->second / e->second) / (122e6 / 25.8e9), 2);
    auto keys = study_keys(study);
    const auto known_key = [&](const std::string& name, const std::string& where) -> StudyKey& {
        const auto key = keys.find(name);
        if (key != keys.end()) return key->second;
        std::vector<std::string> known;
        for (const auto& [each, unused] : keys) known.push_back(each);
        throw UsageError(fmt::format("{}: unknown key; known are {}", where, fmt::join(known, ", ")));
    };
    const auto set = [&](StudyKey& key, const std::vector<std::string>& texts, const std::string& where) {
        if (texts.empty() || (texts.size() > 1 && !key.several)) throw UsageError(where + ": one value is needed");
        std::vector<double> values;
        for (const std::string& text : texts) values.push_back(parse_quantity(text, key.quantity, where));
        key.set(values);
    };
    const TomlFile toml = read_toml(rock.file.string());
    for (const TomlEntry& entry : toml.entries) {
        if (entry.section != std::vector<std::string>{"study"}) continue;
        const std::string where = fmt::format("{}: line {}: study.{}", toml.file, entry.line, entry.key);
        std::vector<std::string> texts;
        for (const TomlValue& value : entry.values) texts.push_back(value.text);
        try {
            set(known_key(entry.key, where), texts, where);
        } catch (const UsageError& error) {
            throw InputError(error.what());
        }
    }
    for (const std::string& setting : settings) {
        const std::size_t at = setting.find('=');
        if (at == 0 || at == std::string::npos) throw UsageError(fmt::format("--set {}: KEY=VALUE is needed", setting));
        std::vector<std::string> texts;
        std::istringstream list(setting.substr(at + 1));
        for (std::string text; std::getline(list, text, ',');) texts.push_back(text);
        const std::string where = "--set " + setting;
        set(known_key(setting.substr(0, at), where), texts, where);
    }
    return study;
}

std::vector<FinishedRun> read_finished(const std::string& folder) {
    const fs::path place(folder);
    const TableFile table((place / "strength.tsv").string());
    const auto rows = table.texts("file");
    const auto tests = table.texts("test");
    const auto kinds = table.texts("peak_kind");
    const auto seeds = table.numbers("seed");
    const auto pressures = table.numbers("confining_pressure_MPa");
    const auto limits = table.numbers("max_strain");
    const auto edges = table.numbers("mean_edge_mm");
    const auto times = table.numbers("wall_time_s");
    const auto compressive = table.numbers_or_nan("peak_compressive_stress_MPa");
    const auto tensile = table.numbers_or_nan("tensile_strength_MPa");
    std::array<std::vector<double>, n_parameters> values;
    for (std::size_t i = 0; i < n_parameters; ++i) values[i] = table.numbers(parameters()[i].column);
    std::vector<FinishedRun> runs;
    std::vector<std::string> files;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        FinishedRun run;
        run.test = tests[row];
        run.confining_pressure = pressures[row] * 1e6;
        run.seed = static_cast<std::int64_t>(seeds[row]);
        for (std::size_t i = 0; i < n_parameters; ++i) run.values[i] = values[i][row] * parameters()[i].si;
        run.max_strain = limits[row];
        run.mean_edge = edges[row] * 1e-3;
        run.wall_time = times[row];
        run.strength = (std::isnan(tensile[row]) ? compressive[row] : tensile[row]) * 1e6;
        run.has_peak = kinds[row] == "drop";
        if (std::isnan(run.strength)) continue;
        runs.push_back(run);
        files.push_back(rows[row]);
    }
    const std::string moduli = (place / "moduli.tsv").string();
    const std::string toughness = (place / "toughness.tsv").string();
    if (std::find(tests.begin(), tests.end(), "uniaxial") != tests.end()) add_measures(moduli, moduli_measures, files, runs);
    if (fs::exists(toughness)) add_measures(toughness, toughness_measures, files, runs);
    return runs;
}

std::string wanted_table(const Study& study, const std::vector<WantedRun>& wanted) {
    std::string text = "file\tspecimen\tmesh\tmaterial\tsolve\treason\n";
    for (const WantedRun& run : wanted) {
        const std::string pressure = run.test == "triaxial" ? fmt::format("{:.7g}", run.confining_pressure * 1e-6) : "";
        const std::string specimen = specimen_name(study.specimens, run);
        std::string file = run.test + pressure + "_" + specimen;
        std::string settings;
        for (const ParameterRow& row : parameters()) {
            if (!run.point[row.parameter]) continue;
            const std::string value = fmt::format("{:.6g}", *run.point[row.parameter] / row.si);
            file += fmt::format("_{}{}", row.name, value);
            settings += fmt::format("{}--set {}={}{}", settings.empty() ? "" : " ", row.key, value, unit_in_files(row));
        }
        std::string test = run.test;
        if (!pressure.empty()) test += fmt::format(" --confining-pressure {}MPa", pressure);
        if (run.test == "uniaxial" || run.test == "triaxial") {
            const std::string limit = fmt::format("{:.5g}", run.max_strain.value_or(study.max_strain));
            file += "_cap" + limit;
            test += " --max-strain " + limit;
        }
        const std::string mesh = mesh_options(study.specimens, run);
        text += fmt::format("{}.h5\t{}\t{}\t{}\t{}\t{}\n", file, specimen, mesh, settings, test, run.reason);
    }
    return text;
}

std::string material_text(const Material& rock, const Point& point, const char* what, const Decision& fitted) {
    const Material at = material_at(rock, point);
    std::string text = fmt::format("name = \"{}, {}\"\n\n[rock]\n", rock.name, what);
    text += fmt::format(
        "young_modulus = {}\npoisson_ratio = {:.7g}\ndensity = {}\nmode_i_toughness = {}\nmode_ii_toughness = {}\n"
        "tensile_strength = {}\n",
        si_text(at.rock.young_modulus, 1e9, "GPa"), at.rock.poisson_ratio, si_text(at.rock.density, 1, "kg/m3"),
        si_text(at.rock.mode_i_toughness, 1e6, "MPa.m^0.5"), si_text(at.rock.mode_ii_toughness, 1e6, "MPa.m^0.5"),
        si_text(at.rock.tensile_strength, 1e6, "MPa"));
    text += contact_text(at, point);
    text += fmt::format("\n[platen]\nfriction_angle = {:.9g}\n\n[laboratory]\n", at.platen_friction_angle);
    for (const auto& [key, value] : rock.laboratory) text += fmt::format("{} = {:.9g}\n", key, value);
    text += "\n[fitted]  # property: what it was fitted to, and what new specimens have\n";
    for (const Outcome& o : fitted.outcomes) {
        if (o.target.role != Role::fitted || !o.ours) continue;
        const Target& t = o.target;
        const std::string key =
            t.name == confined_strength ? fmt::format("{}_{:g}MPa", t.name, t.confining_pressure * 1e-6) : t.name;
        text += fmt::format("{} = \"{:.5g}{}{}; {} on {} new specimens\"\n", key, t.value / t.si, t.unit.empty() ? "" : " ",
                            t.unit, with_interval(*o.ours, t.si), o.specimens);
    }
    return text;
}

/// Whether a point has what a material needs: a calibration may end before it comes to its contacts.
bool has_strengths(const Point& point) {
    return point[Parameter::tensile_strength] && point[Parameter::cohesion] && point[Parameter::friction_angle];
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

Decision calibrate_folder(const std::string& folder, const std::string& material, const std::vector<std::string>& settings,
                          std::ostream& diagnostics) {
    const fs::path place(folder);
    const Material rock = read_rock(material.empty() ? (place / "material.toml").string() : material);
    write_notes(diagnostics, "calibrate", rock);
    const Study study = read_study(rock, settings);
    std::vector<FinishedRun> finished;
    if (fs::exists(place / "strength.tsv")) finished = read_finished(folder);
    Decision decision = decide(rock, study, finished);
    for (const char* name : {"wanted.tsv", "calibrated.toml", "nearest.toml", "report.md"}) remove_file((place / name).string());
    if (decision.ending == Ending::wanted) {
        write_whole_file((place / "wanted.tsv").string(), wanted_table(study, decision.wanted));
        return decision;
    }
    write_whole_file((place / "report.md").string(), report_text(rock, study, decision, finished.size()));
    const bool calibrated = decision.ending == Ending::calibrated;
    if (calibrated || has_strengths(decision.point)) {
        write_whole_file((place / (calibrated ? "calibrated.toml" : "nearest.toml")).string(),
                         material_text(rock, decision.point, calibrated ? "calibrated" : "nearest point", decision));
    }
    return decision;
}

}  // namespace graincrack::calibrate
