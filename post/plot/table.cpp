#include "post/plot/table.hpp"

#include <filesystem>

#include "post/chart/chart.hpp"
#include "post/chart/labels.hpp"
#include "post/plot/make_plot.hpp"
#include "post/table/table_file.hpp"
#include "share/command_line.hpp"

namespace graincrack {

namespace {

struct Curve {
    std::string label;
    std::vector<double> x;
    std::vector<double> y;
};

std::vector<Curve> curves_of(const std::vector<std::string>& files, const TablePlotOptions& options) {
    std::vector<Curve> curves;
    for (const std::string& file : files) {
        const TableFile table(file);
        const std::string name = std::filesystem::path(table.name()).filename().string();
        for (const std::string& y : options.y) {
            const std::string label = files.size() == 1 ? column_label(y) : name + ": " + column_label(y);
            curves.push_back({label, table.numbers_or_nan(options.x), table.numbers_or_nan(y)});
        }
    }
    return curves;
}

Axis axis_over(const std::vector<Curve>& curves, const std::string& label, std::vector<double> Curve::*column) {
    std::vector<double> all;
    for (const Curve& curve : curves) all.insert(all.end(), (curve.*column).begin(), (curve.*column).end());
    const auto [low, high] = padded_range(all, 0.05);
    return {label, low, high};
}

}  // namespace

Drawing draw_tables(const std::vector<std::string>& files, const TablePlotOptions& options) {
    const std::vector<Curve> curves = curves_of(files, options);
    const std::string y_label = options.y.size() == 1 ? column_label(options.y[0]) : "";
    Chart chart({}, axis_over(curves, column_label(options.x), &Curve::x), axis_over(curves, y_label, &Curve::y));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Marker marker{palette::series(i), marker_shape(i)};
        const Stroke stroke{palette::series(i), 4};
        if (options.points) {
            chart.points(curves[i].x, curves[i].y, marker);
            chart.legend(marker, curves[i].label);
        } else {
            chart.line(curves[i].x, curves[i].y, stroke);
            chart.legend(stroke, curves[i].label);
        }
    }
    return chart.finish();
}

Command table_plot() {
    struct Options : PlotOptions {
        TablePlotOptions columns;
    };
    return make_plot<Options>(
        "table", "columns of tables against each other",
        {"strength.tsv --x mean_edge_mm --y tensile_strength_MPa --points -o table.png",
         "strength.tsv --x strain_at_peak --y tensile_cracks --y shear_cracks --points -o table.svg"},
        FileArguments{"tables", "tables"},
        [](CLI::App& app, Options& options) {
            app.add_option("--x", options.columns.x, "column along x")->required();
            add_names(app, "--y", options.columns.y, "NAME", "column along y; may be given again");
            app.get_option("--y")->required();
            app.add_flag("--points", options.columns.points, "points instead of lines");
            add_picture(app, options);
        },
        [](const Options& options, const Call& call) { return draw_tables(call.files, options.columns); });
}

}  // namespace graincrack
