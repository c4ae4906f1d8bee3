#include "post/kind/kind_table.hpp"

#include <cmath>

namespace graincrack {

void write_kind_terms(std::ostream& out, const KindSurface& surface, TableFormat format) {
    TableWriter table(
        out, {"property", "term", "coefficient", "standard_error", "scatter", "rock_deviation", "prediction_error", "specimens"},
        format);
    for (const auto& [property, model] : surface.models()) {
        for (std::size_t k = 0; k < model.terms.size(); ++k) {
            table.row({property, surface.name_of(model.terms[k]), model.coefficients(static_cast<Eigen::Index>(k)),
                       model.standard_error(k), model.scatter(), std::sqrt(model.rock_variance), model.prediction_error(),
                       model.n_values});
        }
    }
}

void write_kind_rocks(std::ostream& out, const KindSurface& surface, const std::vector<KindRow>& rows, TableFormat format) {
    TableWriter table(out,
                      {"rock", "property", "confining_pressure", "measured", "predicted", "specimens", "off_percent",
                       "low_percent", "high_percent"},
                      format);
    for (const KindRow& row : rows) {
        if (!row.is_rock || row.kind != surface.kind()) continue;
        const Property& property = property_named(row.property);
        std::vector<Cell> cells{row.point, row.property, row.confining_pressure, row.value, {}, row.specimens, {}, {}, {}};
        if (const auto found = surface.predict(row.at, property, row.confining_pressure)) {
            const KindModel& model = *surface.model(property, row.confining_pressure);
            const double deviation =
                std::sqrt(std::pow(found->mean_deviation, 2) - model.rock_variance + model.variance / row.specimens);
            const auto off = [&](double deviations) {
                return 100 * (found->value / row.value * std::exp(deviations * deviation) - 1);
            };
            cells[4] = found->value;
            cells[6] = off(0);
            cells[7] = off(-deviations_of_95_percent);
            cells[8] = off(deviations_of_95_percent);
        }
        table.row(cells);
    }
}

}  // namespace graincrack
