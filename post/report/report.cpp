#include "post/report/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "post/chart/axis.hpp"
#include "post/cracks/crack_counts.hpp"
#include "post/cracks/rosette.hpp"
#include "post/measure/caveats.hpp"
#include "post/measure/moduli.hpp"
#include "post/plot/plots.hpp"
#include "post/report/comparison.hpp"
#include "post/report/html.hpp"
#include "post/report/quality_checks.hpp"
#include "post/report/test_report.hpp"
#include "post/report/view_page.hpp"
#include "post/run/comparability.hpp"
#include "post/run/crystals.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/units.hpp"
#include "solver/law/table.hpp"

namespace graincrack {

namespace {

using html::number;

std::string asked_for(const std::optional<Material>& material, const std::string& phase) {
    if (!material) return "";
    const auto found = material->fabric.phases.find(phase);
    return found == material->fabric.phases.end() ? "" : number(100 * found->second.fraction);
}

/// "61.61 to 65.55": the bounds of E of the grains alone, GPa; one number where they agree.
std::string bounds_of(const GrainModuli& grains) {
    const std::string low = number(grains.reuss * 1e-9);
    const std::string high = number(grains.voigt * 1e-9);
    return low == high ? low : low + " to " + high;
}

/// The part of the page about specimens with several phases: their composition, and which of their contacts cracked.
class Minerals {
public:
    /// Adds the composition of a specimen. \param kind its name \param material for the fractions that were asked for
    void add_phases(const std::string& kind, const Specimen& specimen, const RunHeader& header,
                    const std::optional<Material>& material) {
        if (specimen.phase_names.size() < 2) return;
        const std::vector<double> reached = phase_fractions(specimen);
        for (std::size_t p = 0; p < reached.size(); ++p) {
            const Phase& phase = header.fabric.phases.at(p);
            const auto grains = std::count(specimen.grain_phase.begin(), specimen.grain_phase.end(), p);
            phases_.row({p == 0 ? kind : " ", mineral_label(specimen.phase_names[p]),
                         asked_for(material, specimen.phase_names[p]), number(100 * reached[p]), std::to_string(grains),
                         number(phase.young_modulus * 1e-9), number(phase.poisson_ratio, 3), number(phase.density)});
        }
        const GrainModuli mean = grain_moduli(header, specimen);
        phases_.row({" ", "all, Reuss to Voigt", " ", "100", std::to_string(specimen.n_grains()), bounds_of(mean),
                     number(mean.poisson_ratio, 3), " "});
    }
    /// Adds contacts and cracks of a run. \param kind of the test
    void add_classes(const std::string& kind, const RunClasses& run) {
        if (run.classes.size() < 2) return;
        for (std::size_t k = 0; k < run.classes.size(); ++k) {
            const ClassCounts& each = run.classes[k];
            const ModeCounts peak = each.at_peak.value_or(ModeCounts{});
            classes_.row({k == 0 ? kind : " ", mineral_label(each.name), std::to_string(each.contacts),
                          number(100 * each.length / run.length(), 3), number(peak.tensile, 6), number(peak.shear, 6),
                          number(each.at_end.tensile, 6), number(each.at_end.shear, 6)});
        }
    }
    /// Both tables; empty if no specimen has several phases.
    [[nodiscard]] std::string str() const {
        if (phases_.empty()) return "";
        return phases_.str() + (classes_.empty() ? "" : "<h3>Contacts and micro-cracks by class</h3>\n" + classes_.str());
    }

private:
    html::Table phases_{{"specimen", "phase", "asked for, % of area", "reached, %", "grains", "E, GPa", "ν", "density, kg/m³"}};
    html::Table classes_{
        {"test", "contacts", "number", "% of length", "tensile cracks at peak", "shear", "tensile at end", "shear"}};
};

/// Everything the page is made of.
struct Content {
    std::vector<std::string> files;  ///< each test of a specimen once
    std::string other_material;      ///< that the runs are not of the material that was given; "" if they are
    std::vector<TestReport> tests;
    std::vector<SeedGroup> groups;                 ///< of the tests
    html::Figures mesh;                            ///< of specimens
    std::vector<ViewedRun> viewed;                 ///< the first run of each series, as far as it has frames
    std::map<std::size_t, std::size_t> viewed_of;  ///< the place there of a file
    std::string grains;                            ///< that were asked for and made
    std::string maps;                              ///< figures of the first run of each series
    Minerals minerals;                             ///< of these specimens and runs
    std::vector<FabricEnvelope> envelopes;
    std::string envelope_note;
};

/// A map of a file at its last frame or at its peak; "" of one without frames.
std::string crack_map(const Content& content, std::size_t file, bool is_last, int height) {
    const auto found = content.viewed_of.find(file);
    if (found == content.viewed_of.end()) return "";
    const std::size_t last = content.viewed[found->second].frames - 1;
    return is_last || last > 0 ? html::map_figure(found->second, is_last ? last : 0, height) : "";
}

/// Pictures of one run of a kind, two by two.
std::string map_figures(const Content& content, std::size_t file, const RunReader& run, const std::string& name,
                        const CrackLabelChoice& label) {
    const TestReport& t = content.tests[file];
    const Specimen specimen = run.specimen();
    html::Figures figures;
    for (const bool is_last : {false, true}) {
        if (const std::string map = crack_map(content, file, is_last, 560); !map.empty()) figures.add_map(map);
    }
    figures.add("energy balance", [&](const PictureStyle& style) { return draw_energy(t.data, style); });
    const std::vector<Crack> cracks = read_labelled_cracks(run, specimen, label);
    if (!cracks.empty()) {
        figures.add("directions of the cracks by the end", [&](const PictureStyle& style) {
            return draw_rosette(crack_rosette(cracks, specimen), test_title(t.data.header), t.data.name,
                                definition_of(label.of(t.data.header)), style);
        });
    }
    if (is_compression(t.data.header)) {
        figures.add("thresholds", [&](const PictureStyle& style) { return draw_thresholds(t.data, style); });
    }
    return figures.under(name + " (" + t.data.name + ")");
}

std::vector<RunData> data_of(const Content& content) {
    std::vector<RunData> runs;
    for (const TestReport& t : content.tests) runs.push_back(t.data);
    return runs;
}

/// The envelopes of the compression tests of each fabric, if they are there and have peaks; else why not.
void add_envelopes(Content& content) {
    std::vector<RunData> runs = data_of(content);
    runs.erase(std::remove_if(runs.begin(), runs.end(), [](const RunData& run) { return !distinct_shape(run).empty(); }),
               runs.end());
    for (const ComparableGroup& fabric : comparable_groups(list_of(runs), of_the_test, {SettingGroup::heat})) {
        std::vector<RunData> own;
        for (const std::size_t i : fabric.runs) own.push_back(runs[i]);
        const std::string heat = own.front().header.heat_label();
        const std::string name = heat + (heat.empty() || fabric.distinction.empty() ? "" : ", ") + fabric.distinction;
        try {
            EnvelopeTests tests = collect_envelope_tests(own, {});
            const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
            content.envelopes.push_back({name, !heat.empty(), std::move(tests), envelope});
        } catch (const InputError& error) {
            content.envelope_note +=
                html::paragraph(fmt::format("No envelope{}: {}.", name.empty() ? "" : " of " + name, error.what()));
        }
    }
}

/// The grains of a specimen as requested and as made.
std::string grains_paragraph(const H5Input& file, const Specimen& specimen, const std::string& name) {
    const std::string asked = asked_grains(file);
    if (asked.empty()) return "";
    const auto crystals = crystal_sizes(file);
    const MeshStatistics& s = specimen.statistics;
    return html::paragraph(fmt::format("Grains of {}: {} asked for; {}, mean diameter {} with a variation of {}{}.", name, asked,
                                       grains_label(specimen),
                                       format_quantity(crystals ? crystals->mean_diameter : s.mean_diameter, Dimension::length),
                                       format_number(crystals ? crystals->variation : s.diameter_variation, 3),
                                       crystals ? ", " + format_number(crystals->elements, 3) + " elements each" : ""));
}

/// Pictures of the first run of each kind, and of the first specimen of each shape and distinction: no map stands there twice.
void add_maps(Content& content, const ReportOptions& options) {
    std::set<std::string> seen;
    for (const SeedGroup& row : content.groups) {
        const std::size_t first = row.indices.front();
        const RunReader run(content.files[first]);
        const TestReport& t = content.tests[first];
        const Specimen specimen = run.specimen();
        const std::string kind = row.with_specimen(specimen.shape);
        if (seen.insert(kind).second) {
            content.mesh.add_specimen(kind + ", of " + t.data.name,
                                      [specimen](const PictureStyle& style) { return draw_specimen(specimen, style); });
            content.grains += grains_paragraph(run.file(), specimen, kind + ", of " + t.data.name);
            content.minerals.add_phases(kind, specimen, t.data.header, options.material);
        }
        if (run.n_frames() > 0) {
            content.viewed_of[first] = content.viewed.size();
            content.viewed.push_back(viewed_run(run, {options.label, 2}));
        }
        content.maps += map_figures(content, first, run, row.name(), options.label);
        content.minerals.add_classes(row.name(), read_classes(run, options.label));
    }
}

/// Drops what is there twice. \param diagnostics gets a line for each
void count_once(Content& content, std::ostream& diagnostics) {
    RunList runs;
    for (const TestReport& t : content.tests) runs.push_back(&t.data);
    std::vector<std::string> files;
    std::vector<TestReport> tests;
    for (const std::size_t i : once_each(runs, "report", diagnostics)) {
        files.push_back(content.files[i]);
        tests.push_back(std::move(content.tests[i]));
    }
    std::swap(content.files, files);
    std::swap(content.tests, tests);
}

/// Drops a material that the first run is not of. \return what is to be said of that
std::string drop_other_material(ReportOptions& options, const RunHeader& run, std::ostream& diagnostics) {
    if (!options.material) return "";
    const std::string found = difference_from(*options.material, run);
    if (found.empty()) {
        write_notes(diagnostics, "report", *options.material);
        return "";
    }
    options.material.reset();
    return "the runs are of another material than the one given: they differ from it in " + found +
           "; nothing is compared with its laboratory";
}

/// \throws InputError if they differ
void require_one_material(const RunData& run, const RunData& first) {
    SettingGroups except = of_the_test;
    except.insert({SettingGroup::grain_size, SettingGroup::fabric});
    const std::string found = differences(run, first, except);
    if (found.empty()) return;
    throw InputError(run.name + ": differs from " + first.name + " in " + found + "; a report needs tests of one material");
}

/// \param options gets the material of the first run unless one is given
Content read_content(const std::vector<std::string>& runs, ReportOptions& options, Verbosity verbosity,
                     std::ostream& diagnostics) {
    Content content;
    content.files = runs;
    const bool is_given = options.material.has_value();
    Progress progress("report", verbosity);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        throw_if_interrupted();
        const RunReader run(runs[i]);
        content.tests.push_back(read_test_report(run, options.label));
        const TestReport& t = content.tests.back();
        if (i == 0) content.other_material = drop_other_material(options, t.data.header, diagnostics);
        if (i == 0 && !content.other_material.empty()) say(diagnostics, "report: " + content.other_material);
        require_one_material(t.data, content.tests.front().data);
        progress.update(static_cast<double>(i + 1) / static_cast<double>(runs.size()), t.data.name);
    }
    progress.finish();
    count_once(content, diagnostics);
    content.groups = seed_groups(content.tests);
    const TestReport& first = content.tests.front();
    if (!is_given) options.material = material_of_run(first.data.header, first.material);
    add_maps(content, options);
    add_envelopes(content);
    return content;
}

std::string kind_of(const RunData& run) {
    return is_compression(run.header) ? "compression"
                                      : run.header.test + (distinct_shape(run).empty() ? "" : " " + distinct_shape(run));
}

/// Caveats of the strengths of runs, a line each. \param kind of these runs; "" for all
std::vector<std::string> caveat_lines(const Content& content, const std::string& kind = "") {
    CaveatCount doubts;
    for (const TestReport& t : content.tests) {
        if (kind.empty() || kind_of(t.data) == kind) doubts.add(t.data, t.caveats);
    }
    return doubts.lines();
}

/// Beside strengths, their caveats.
std::string caveat_paragraph(const Content& content) {
    const std::vector<std::string> lines = caveat_lines(content);
    return lines.empty() ? "" : html::paragraph(fmt::format("Caveats of these strengths: {}.", fmt::join(lines, "; ")));
}

/// Curves; tests whose stresses mean the same share a chart.
std::string curve_figures(const Content& content, const ReportOptions& options) {
    html::Figures figures;
    std::map<std::string, std::vector<RunData>> kinds;
    for (const TestReport& t : content.tests) kinds[kind_of(t.data)].push_back(t.data);
    for (const auto& each : kinds) {
        const std::string& kind = each.first;
        const std::vector<RunData>& runs = each.second;
        figures.add("stress and strain: " + kind, [&](const PictureStyle& style) {
            return draw_curves(runs, definition_of(options.label.of(runs.front().header)), caveat_lines(content, kind), style);
        });
    }
    return figures.str();
}

std::string envelope_section(const Content& content) {
    html::Figures figures;
    for (const FabricEnvelope& each : content.envelopes) {
        figures.add("Mohr circles and envelopes", [&](const PictureStyle& style) {
            const std::string title =
                content.tests.front().data.header.material + (each.fabric.empty() ? "" : ", " + each.fabric);
            return draw_envelope(each.tests, title, style);
        });
    }
    return (figures.empty() ? "" : figures.str()) + content.envelope_note;
}

/// The curves of the first run of each group that shares a chart with the first compression test, or with the first test; the
/// cracks of the first of them; and the envelope.
std::string first_figures(const Content& content, const ReportOptions& options) {
    const auto& groups = content.groups;
    const auto compression = std::find_if(groups.begin(), groups.end(),
                                          [](const SeedGroup& group) { return is_compression(group.first().data.header); });
    const SeedGroup& shown = compression == groups.end() ? groups.front() : *compression;
    std::vector<RunData> curves;
    for (const SeedGroup& group : groups) {
        if (kind_of(group.first().data) == kind_of(shown.first().data)) curves.push_back(group.first().data);
    }
    html::Figures figures;
    figures.add(
        curves.size() < content.tests.size() ? "stress and strain of the first run of each kind" : "stress and strain",
        [&](const PictureStyle& style) {
            return draw_curves(curves, definition_of(options.label.of(curves.front().header)), {}, style);
        },
        "curves");
    const std::string map = crack_map(content, shown.indices.front(), true, 420);
    if (!map.empty()) figures.add_map(map);
    if (!content.envelopes.empty()) {
        const FabricEnvelope& envelope = content.envelopes.front();
        figures.add(
            "Mohr circles and envelopes" + (envelope.fabric.empty() ? "" : ", " + envelope.fabric),
            [&](const PictureStyle& style) {
                return draw_envelope(envelope.tests, content.tests.front().data.header.material, style);
            },
            "envelope");
    }
    return figures.first();
}

/// A row of a parameter of all contacts, or a cell for each class where they differ.
std::vector<std::string> contact_row(const std::string& label, const std::vector<ContactParameters>& classes,
                                     double ContactParameters::*value, Dimension dimension) {
    std::vector<std::string> row{label};
    for (const ContactParameters& each : classes) row.push_back(format_quantity(each.*value, dimension));
    if (std::equal(row.begin() + 2, row.end(), row.begin() + 1)) row.resize(2);
    return row;
}

/// Parameters of all contacts, and below them those that differ by class, with a row for each class.
std::string parameter_tables(const TestReport& test) {
    const RunHeader& h = test.data.header;
    const std::vector<ContactParameters>& classes = h.fabric.contacts;
    html::Table table({"parameter", "value"});
    std::vector<std::string> columns{"contacts"};
    std::vector<std::vector<std::string>> rows;
    for (const std::string& name : test.class_names) rows.push_back({mineral_label(name)});
    const auto add = [&](const std::string& label, double value, Dimension dimension) {
        table.row({label, format_quantity(value, dimension)});
    };
    const auto add_contact = [&](const std::string& label, double ContactParameters::*value, Dimension dimension) {
        const std::vector<std::string> row = contact_row(label, classes, value, dimension);
        if (row.size() == 2) {
            table.row(row);
            return;
        }
        columns.push_back(label);
        for (std::size_t k = 0; k < classes.size(); ++k) rows[k].push_back(row[k + 1]);
    };
    const std::string whose = classes.size() > 1 ? "rock" : "grains";
    add("E of the " + whose, h.rock.young_modulus, Dimension::stress);
    add("ν of the " + whose, h.rock.poisson_ratio, Dimension::one);
    add("density", h.rock.density, Dimension::density);
    add("K_IC", h.rock.mode_i_toughness, Dimension::toughness);
    add("K_IIC", h.rock.mode_ii_toughness, Dimension::toughness);
    add("tensile strength of the rock", h.rock.tensile_strength, Dimension::stress);
    const auto& laws = all_contact_laws();
    const auto law = std::find_if(laws.begin(), laws.end(), [&](const LawDescription& l) { return l.name == h.contact_law; });
    for (const ContactParameter& row : all_contact_parameters()) {
        if (!row.every_law && law != laws.end() && !law->reads(row.value)) continue;
        add_contact(std::string(row.quantity.meaning), row.value, row.quantity.dimension);
    }
    add_contact("critical opening δct", &ContactParameters::critical_opening, Dimension::length);
    add_contact("critical sliding δcs", &ContactParameters::critical_sliding, Dimension::length);
    add_contact("ultimate opening δut", &ContactParameters::ultimate_opening, Dimension::length);
    add("platen friction", h.platen_friction, Dimension::angle);
    table.row({"contact law, fracture energy", h.contact_law + ", " + h.fracture_energy_choice});
    if (columns.size() == 1) return table.str();
    html::Table by_class(columns);
    for (const auto& row : rows) by_class.row(row);
    return table.str() + by_class.str();
}

/// Contacts follow the plane condition: one table for each.
std::string parameters(const Content& content) {
    std::map<std::string_view, const TestReport*> planes;
    for (const TestReport& t : content.tests) planes.emplace(name_of(t.data.header.plane), &t);
    std::string out = "<div class=\"columns\">\n";
    for (const auto& [plane, test] : planes) {
        out += "<div><h3>plane " + escape_xml(std::string(plane)) + "</h3>" + parameter_tables(*test) + "</div>\n";
    }
    return out + "</div>\n";
}

std::string provenance(const Content& content) {
    html::Table table({"run", "what", "value"}, true);
    for (const TestReport& t : content.tests) {
        std::string name = t.data.name;
        for (const auto& [what, value] : t.provenance) {
            table.row({name.empty() ? " " : name, what, value});
            name.clear();
        }
    }
    return table.str();
}

}  // namespace

std::string make_report(const std::vector<std::string>& runs, const ReportOptions& given, Verbosity verbosity,
                        std::ostream& diagnostics) {
    ReportOptions options = given;
    const Content content = read_content(runs, options, verbosity, diagnostics);
    const std::optional<Material>& material = options.material;
    const RunHeader& header = content.tests.front().data.header;
    const std::string title =
        content.tests.size() == 1 ? test_title(header) : fmt::format("{}: {} tests", header.material, content.tests.size());
    std::string body = "<h1>" + escape_xml(title) + "</h1>\n<p class=\"lead\">Numerical tests by Graincrack; contact law " +
                       escape_xml(header.contact_law) +
                       ". Strengths are positive; numbers of micro-cracks are numbers of contacts.</p>\n";
    if (!content.other_material.empty()) body += html::paragraph("Note: " + content.other_material + ".", "lead");
    body += first_figures(content, options);
    body += html::section("laboratory", material ? "Against the laboratory" : "Properties",
                          comparison(content.groups, content.envelopes, material, caveat_paragraph(content)));
    body += html::section("means", "Means of runs that differ by their seed alone",
                          group_table(content.groups) + caveat_paragraph(content));
    body += html::section("curves", "Curves", curve_figures(content, options));
    body += html::section("quality-checks", "Quality checks", quality_checks(content.tests));
    body += html::section("envelope", "Envelope", envelope_section(content));
    body += html::section("maps", "Cracks, directions, energy, thresholds", content.maps);
    body += html::section("mesh", "Specimens", content.mesh.str() + content.grains);
    if (const std::string minerals = content.minerals.str(); !minerals.empty()) {
        body += html::section("minerals", "Minerals", minerals);
    }
    body += html::section("inputs", "Parameters", parameters(content));
    body += html::section("provenance", "Provenance", provenance(content));
    return html::page(title, body, map_scripts(content.viewed));
}

}  // namespace graincrack
