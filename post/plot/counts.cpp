#include "post/plot/counts.hpp"

#include <fmt/format.h>

#include "post/chart/chart.hpp"
#include "post/chart/numbers.hpp"
#include "post/cracks/run_state.hpp"
#include "post/measure/test_label.hpp"
#include "post/plot/make_plot.hpp"
#include "share/error.hpp"

namespace graincrack {

namespace {

template <class Get>
std::vector<double> column(const CrackCounts& counts, const Get& get) {
    std::vector<double> values;
    for (const CrackCounts::Moment& m : counts.moments) values.push_back(get(m));
    return values;
}

}  // namespace

Drawing draw_counts(const CrackCounts& counts, const RunData& run, const std::string& definition, const PictureStyle& style) {
    using Moment = CrackCounts::Moment;
    const std::vector<double> strain = column(counts, [](const Moment& m) { return 100 * m.axial_strain; });
    const std::vector<double> stress = column(counts, [](const Moment& m) { return 1e-6 * m.stress; });
    const ModeCounts& last = counts.moments.back().all;
    if (last.tensile + last.shear == 0)
        throw InputError(run.name + ": no micro-cracks; counts over the loading need a run with some");
    Chart chart(style,
                {test_title(run.header), {fmt::format("seed {}, {} grains", run.specimen.seed, run.specimen.grains), definition}},
                Axis{"axial strain, %", 0, 1.03 * largest(strain)},
                Axis{"micro-cracks (contacts)", 0, 1.08 * std::max(last.tensile, last.shear)},
                {Axis{"stress, MPa", 0, 1.08 * largest(stress)}});
    const Stroke load{palette::rim, 4.5, Dash::dotted};
    chart.line(strain, stress, load, Chart::Side::right);
    const auto draw = [&](const std::vector<double>& values, const Stroke& stroke, const std::string& label) {
        chart.line(strain, values, stroke);
        chart.legend(stroke, label);
    };
    if (counts.classes.size() == 1) {
        draw(column(counts, [](const Moment& m) { return m.all.tensile; }), Stroke{palette::tensile, 4}, "tensile");
        draw(column(counts, [](const Moment& m) { return m.all.shear; }), Stroke{palette::shear, 3.5, Dash::dashed}, "shear");
    } else {
        for (std::size_t i = 0; i < counts.classes.size(); ++i) {
            const Colour colour = palette::series(i);
            draw(column(counts, [i](const Moment& m) { return m.by_class[i].tensile; }), Stroke{colour, 4},
                 counts.classes[i] + ", tensile");
            draw(column(counts, [i](const Moment& m) { return m.by_class[i].shear; }), Stroke{colour, 3, Dash::dashed},
                 counts.classes[i] + ", shear");
        }
    }
    chart.legend(load, "stress, right");
    return chart.finish();
}

Command counts_plot() {
    struct Options : PlotOptions {
        CrackLabelChoice label;
    };
    return make_plot<Options>(
        "counts", "micro-cracks over the loading by mode and class of contacts (pair of minerals)",
        {"uniaxial.h5 -o counts.png", "brazilian.h5 --crack-event broken -o counts.svg"}, one_run,
        [](CLI::App& app, Options& options) {
            add_chart(app, options);
            add_crack_label(app, options.label);
        },
        [](const Options& options, const Call& call) {
            const RunReader run(call.file());
            const RunData data = run_data(run);
            const Specimen specimen = run.specimen();
            const std::vector<Crack> cracks = read_labelled_cracks(run, specimen, options.label);
            return draw_counts(count_cracks(data, load_curve(data), specimen, cracks), data,
                               definition_of(options.label.of(run.header())), options.style);
        });
}

}  // namespace graincrack
