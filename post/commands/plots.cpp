#include "post/commands/plots.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>

#include "post/chart/picture.hpp"
#include "post/cracks/crack_counts.hpp"
#include "post/cracks/emission.hpp"
#include "post/cracks/rosette.hpp"
#include "post/cracks/run_state.hpp"
#include "post/measure/test_label.hpp"
#include "post/plot/counts.hpp"
#include "post/plot/curve.hpp"
#include "post/plot/emission.hpp"
#include "post/plot/energy.hpp"
#include "post/plot/envelope.hpp"
#include "post/plot/fragments.hpp"
#include "post/plot/rosette.hpp"
#include "post/plot/size_effect.hpp"
#include "post/plot/specimen.hpp"
#include "post/plot/strength.hpp"
#include "post/plot/surface.hpp"
#include "post/plot/thresholds.hpp"
#include "post/plot/trend.hpp"
#include "share/error.hpp"
#include "share/h5_file.hpp"

namespace graincrack {

namespace {

Drawing curves(const PostOptions& options) {
    std::vector<LaboratoryCurve> laboratory;
    for (const std::string& file : options.laboratory) laboratory.push_back(read_laboratory_curve(file));
    return draw_curves(read_runs(options.files), laboratory);
}

Drawing envelope(const PostOptions& options) {
    const std::vector<RunData> runs = read_runs(options.files);
    std::vector<LaboratoryStrengths> laboratory;
    for (const std::string& file : options.laboratory) laboratory.push_back(read_laboratory_strengths(file));
    return draw_envelope(collect_envelope_tests(runs, options.capped_runs), runs.front().header.material, laboratory);
}

Drawing rosette(const PostOptions& options) {
    const RunReader run(only_file(options));
    const Specimen specimen = run.specimen();
    return draw_rosette(crack_rosette(read_cracks(run, specimen), specimen), test_title(run.header()), run.name());
}

Drawing counts(const PostOptions& options) {
    const RunReader run(only_file(options));
    const RunData data = run_data(run);
    const Specimen specimen = run.specimen();
    return draw_counts(count_cracks(data, load_curve(data), specimen, read_cracks(run, specimen)), data);
}

Drawing emission(const PostOptions& options) {
    const RunReader run(only_file(options));
    const Specimen specimen = run.specimen();
    return draw_emission(emission_of(run, specimen, read_cracks(run, specimen), options.crack_export), test_title(run.header()),
                         run.name());
}

Drawing strength(const PostOptions& options) {
    std::optional<Material> material;
    if (!options.material.empty()) material = read_material(options.material);
    return draw_strengths(read_runs(options.files), material);
}

Drawing law(const PostOptions& options) {
    if (options.files.empty() && options.material.empty()) {
        throw UsageError("plot law: neither a run nor a material; give a run file or --material NAME");
    }
    if (!options.files.empty()) {
        const RunReader run(only_file(options));
        LawPlotOptions own = options.law;
        if (own.laws.empty()) own.laws = {run.header().contact_law};
        own.coupling = run.header().coupling;
        return draw_laws(run.header().contact, fmt::format("{}, {}", run.header().material, run.header().contact_law), own);
    }
    const Material material = read_material(options.material);
    const ContactParameters contact = contact_parameters(material, options.plane, options.fracture_energy);
    return draw_laws(contact, fmt::format("{}, plane {}", material.name, name_of(options.plane)), options.law);
}

Drawing picture_of(const PostOptions& options) {
    const std::map<std::string, std::function<Drawing()>> pictures{
        {"specimen", [&] { return draw_specimen(read_specimen(H5Input(only_file(options)))); }},
        {"curve", [&] { return curves(options); }},
        {"cracks", [&] { return draw_cracks(RunReader(only_file(options)), options.crack_map); }},
        {"fragments", [&] { return draw_fragments(RunReader(only_file(options)), options.crack_map); }},
        {"rosette", [&] { return rosette(options); }},
        {"counts", [&] { return counts(options); }},
        {"emission", [&] { return emission(options); }},
        {"strength", [&] { return strength(options); }},
        {"energy", [&] { return draw_energy(read_run_data(only_file(options))); }},
        {"thresholds", [&] { return draw_thresholds(read_run_data(only_file(options))); }},
        {"envelope", [&] { return envelope(options); }},
        {"size-effect", [&] { return draw_size_effect(collect_sizes(read_runs(options.files), options.capped_runs)); }},
        {"surface", [&] { return draw_surface(ccd::solve_problem(only_file(options), options.ccd)); }},
        {"law", [&] { return law(options); }},
        {"lennard-jones", [&] { return draw_lennard_jones(); }},
        {"trend", [&] { return draw_trend(collect_trends(options.files, options.trend, remarks(options)), options.trend); }},
        {"table", [&] { return draw_tables(options.files, options.table_plot); }},
    };
    const auto picture = pictures.find(options.picture);
    if (picture == pictures.end()) throw UsageError("plot " + options.picture + ": unknown");
    return picture->second();
}

}  // namespace

void write_plot(const PostOptions& options) {
    require_picture_name(options.output);
    write_picture(picture_of(options), options.output);
}

}  // namespace graincrack
