#include "post/calibrate/folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "post/calibrate/predicted.hpp"
#include "post/table/table.hpp"
#include "share/base/error.hpp"
#include "share/base/table_file.hpp"
#include "share/base/toml_document.hpp"
#include "share/file/output_file.hpp"
#include "share/rock/material.hpp"

namespace graincrack::calibrate {

namespace {

namespace fs = std::filesystem;

/// Adds the numbers of a table to the runs of its files.
void add_measures(const std::string& path, FinishedRuns& runs) {
    const TableFile table(path);
    const std::vector<std::string> files = table.texts("file");
    for (const std::string& column : table.columns()) {
        const std::vector<std::string> texts = table.texts(column);
        for (std::size_t row = 0; row < texts.size(); ++row) {
            const auto value = parse_number(texts[row]);
            if (value) runs[fs::path(files[row]).filename().string()][column] = *value;
        }
    }
}

/// The rock, of which [contact] may be missing where it is what a calibration finds.
Material read_rock(const std::string& name_or_file) {
    IncompleteMaterial rock = read_incomplete_material(name_or_file);
    take_laboratory(rock);
    std::erase_if(rock.missing, [](const std::string& key) { return key.starts_with("contact."); });
    if (rock.missing.empty()) return std::move(rock.material);
    throw InputError(fmt::format("{}: missing: {}; a calibration needs all of [rock], or the same in [laboratory]",
                                 rock.material.file.string(), fmt::join(rock.missing, ", ")));
}

/// The material with other values, and what was fitted. \param what it is, behind the name of the rock
std::string material_text(const Material& rock, const Decision& decision, const std::string& what) {
    std::vector<MaterialSetting> settings;
    for (const auto& [key, value] : decision.point) settings.emplace_back(key, value_text(key, value, " "));
    settings.emplace_back("name", rock.name + ", " + what);
    std::vector<std::pair<std::string, std::string>> fitted;
    for (const Outcome& o : decision.outcomes) {
        if (o.target.use != Use::fit || !o.ours) continue;
        fitted.emplace_back(o.target.fitted_name(), fmt::format("{}; {} on {} new specimens", o.target.text(o.target.value),
                                                                with_interval(o.ours->mean, o.target.property.si), o.ours->n));
    }
    TomlDocument file(material_with(rock.file.string(), settings), rock.file.string());
    if (!file.has_table({"fitted"})) file.add_table({"fitted"}, "property: what it was fitted to, and what new specimens have");
    for (const auto& [earlier, words] : rock.fitted) {  // by another calibration
        const auto is_earlier = [&key = earlier](const auto& each) { return each.first == key; };
        if (std::ranges::none_of(fitted, is_earlier)) file.remove({"fitted", earlier});
    }
    for (const auto& [key, words] : fitted) file.set({"fitted", key}, toml_string(words));
    return file.text();
}

std::string requested_table(const Material& rock, const Study& study, const std::vector<RequestedRun>& requested) {
    std::string text = "file\tspecimen\tmesh\tmaterial\tsolve\treason\n";
    std::set<std::string> known;
    for (const RequestedRun& run : requested) {
        const RunRow row = row_of(rock, study, run);
        if (!known.insert(row.file).second) continue;
        text += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\n", row.file, row.specimen, row.mesh, row.material, row.solve, run.reason);
    }
    return text;
}

/// Time of runs, by the mean of finished ones of the same test; 0 if there are none of one of the tests.
double time_of(const std::vector<RequestedRun>& requested, const FinishedRuns& finished) {
    double sum = 0;
    for (const RequestedRun& run : requested) {
        std::vector<double> times;
        for (const auto& [name, measures] : finished) {
            const auto time = measures.find("wall_time_s");
            if (name.starts_with(run.test.label() + "_") && time != measures.end()) times.push_back(time->second);
        }
        if (times.empty()) return 0;
        sum += sample(times).mean.value;
    }
    return sum;
}

}  // namespace

FinishedRuns read_finished(const std::string& folder) {
    FinishedRuns runs;
    for (const char* name : {"strength.tsv", "moduli.tsv", "toughness.tsv"}) {
        const fs::path path = fs::path(folder) / name;
        if (fs::exists(path)) add_measures(path.string(), runs);
    }
    return runs;
}

Problem read_problem(const Material& rock, const std::vector<std::string>& settings) {
    const TomlFile file = read_toml(rock.file.string());
    Problem problem;
    problem.study = read_study(rock, file, settings);
    problem.targets = targets_of(rock, file, problem.study.confining_pressure, problem.study.predicted_pressures);
    problem.parameters = parameters_of(rock, file, problem.study.specimens.mean_edge());
    problem.young_modulus = rock.rock.young_modulus;
    problem.poisson_ratio = rock.rock.poisson_ratio;
    problem.rock = rock;
    if (const auto kind = KindSurface::of(rock)) problem.kind = std::make_shared<const KindSurface>(*kind);
    for (const ContactParameter& row : all_contact_parameters()) {
        const std::string key = "contact." + row.key();
        const bool free = std::ranges::any_of(problem.parameters, [&](const Parameter& p) { return p.key == key; });
        if (row.is_needed() && !free && !(rock.contact.*row.given) && !(rock.ratios.*row.given)) {
            throw InputError(fmt::format("{}: {} is neither given nor a row of [parameters]", rock.file.string(), key));
        }
    }
    return problem;
}

FolderDecision calibrate_folder(const std::string& folder, const std::string& material, const std::vector<std::string>& settings,
                                std::ostream& diagnostics) {
    const fs::path parent(folder);
    const auto path = [&](const std::string& name) { return (parent / name).string(); };
    remove_file(path("outcome.json"));
    const Material rock = read_rock(material.empty() ? path("material.toml") : material);
    write_notes(diagnostics, "calibrate", rock);
    const Problem problem = read_problem(rock, settings);
    const FinishedRuns finished = read_finished(folder);
    FolderDecision out{decide(problem, [&](const RequestedRun& run) -> const Measures* {
        const auto found = finished.find(row_of(rock, problem.study, run).file);
        return found == finished.end() ? nullptr : &found->second;
    })};
    const Decision& decision = out.decision;
    for (const char* name : {"wanted.tsv", "calibrated.toml", "nearest.toml", "report.md", "identify.tsv", "draws.tsv"}) {
        remove_file(path(name));
    }
    std::map<std::string, std::string> files;
    const auto write = [&](const std::string& what, const std::string& name, const std::string& text) {
        write_whole_file(path(name), text);
        files[what] = name;
    };
    const Findings findings = findings_of(rock, problem, decision, finished.size());
    if (decision.ending == Ending::requested) {
        write("wanted", "wanted.tsv", requested_table(rock, problem.study, decision.requested));
        out.requested_time = time_of(decision.requested, finished);
    } else {
        std::optional<Material> at;
        if (!decision.point.empty()) {
            const bool calibrated = decision.ending == Ending::calibrated;
            const std::string name = calibrated ? "calibrated.toml" : "nearest.toml";
            const std::string text = material_text(rock, decision, calibrated ? "calibrated" : "nearest point");
            write("material", name, text);
            at = read_material(path(name));
            if (!findings.predictions.empty()) write("material", name, with_predictions(text, *at, findings.predictions));
        }
        if (decision.fit) write("sensitivities", "identify.tsv", identify_table(findings.sensitivities));
        if (findings.draws) write("draws", "draws.tsv", draws_table(findings));
        write("report", "report.md", report_text(findings, at));
    }
    write_whole_file(path("outcome.json"), outcome_text(findings, files));
    return out;
}

}  // namespace graincrack::calibrate
