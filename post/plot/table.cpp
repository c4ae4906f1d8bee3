#include "post/plot/plots.hpp"

#include <filesystem>
#include <optional>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "share/base/table_file.hpp"

namespace graincrack {

namespace {

struct ColumnCurve {
    std::string label;
    std::vector<double> x;
    std::vector<double> y;
};

std::vector<ColumnCurve> column_curves(const std::vector<std::string>& files, const TablePlotOptions& options,
                                       const PictureStyle& style) {
    std::vector<ColumnCurve> curves;
    for (const std::string& file : files) {
        const TableFile table(file);
        std::string name = style.label_of(file);
        if (name.empty()) name = std::filesystem::path(table.name()).filename().string();
        for (const std::string& y : options.y) {
            std::string label = files.size() > 1 || !style.labels.empty() ? name : "";
            if (label.empty() || options.y.size() > 1) label += (label.empty() ? "" : ": ") + column_label(y);
            curves.push_back({label, table.numbers_or_nan(options.x), table.numbers_or_nan(y)});
        }
    }
    return curves;
}

/// Label of an axis for several columns: their names or, if these are long, their unit.
std::string common_label(const std::vector<std::string>& columns) {
    if (columns.size() == 1) return column_label(columns[0]);
    std::string names;
    std::optional<std::string> unit;
    bool same = true;
    for (const std::string& column : columns) {
        const Axis axis{column_label(column)};
        same = same && (!unit || *unit == axis.unit());
        unit = axis.unit();
        names += (names.empty() ? "" : "; ") + axis.label.substr(0, axis.label.find(", "));
    }
    if (!same) return "";  // the legend has the units
    constexpr std::size_t long_label = 50;
    if (names.size() > long_label) names = unit->empty() ? "" : "value";
    return names + (unit->empty() || names.empty() ? "" : ", " + *unit);
}

Axis axis_over(const std::vector<ColumnCurve>& curves, const std::string& label, std::vector<double> ColumnCurve::*column) {
    std::vector<double> all;
    for (const ColumnCurve& curve : curves) all.insert(all.end(), (curve.*column).begin(), (curve.*column).end());
    const auto [low, high] = padded_range(all, 0.05);
    return {label, low, high};
}

}  // namespace

Drawing draw_tables(const std::vector<std::string>& files, const TablePlotOptions& options, const PictureStyle& style) {
    const std::vector<ColumnCurve> curves = column_curves(files, options, style);
    const std::string y_label = common_label(options.y);
    Chart chart(style, {}, axis_over(curves, column_label(options.x), &ColumnCurve::x),
                axis_over(curves, y_label, &ColumnCurve::y));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const ColumnCurve& curve = curves[i];
        if (options.points) chart.points(curve.x, curve.y, {palette::series(i), marker_shape(i)}, curve.label);
        if (!options.points) chart.line(curve.x, curve.y, series_stroke(i), curve.label);
    }
    return chart.finish();
}

}  // namespace graincrack
