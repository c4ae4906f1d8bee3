#include "share/file/sensitivity.hpp"

#include <span>

#include "share/base/quantities.hpp"
#include "share/file/schema.hpp"

namespace graincrack {
namespace {

struct Column {
    const char* name;
    double SensitivityRow::*member;
    Dimension dimension;
    const char* description;
};
constexpr Column columns[] = {
    {"peak_axial_stress", &SensitivityRow::peak_axial_stress, Dimension::stress, "largest axial stress in the sense of the test"},
    {"strain_at_peak", &SensitivityRow::strain_at_peak, Dimension::one, "platen travel over height then"},
    {"post_peak_slope", &SensitivityRow::post_peak_slope, Dimension::stress, "stress over strain from the peak to the end"},
    {"tensile_cracks", &SensitivityRow::tensile_cracks, Dimension::one, "contacts failed in tension at the peak (points / 2)"},
    {"shear_cracks", &SensitivityRow::shear_cracks, Dimension::one, "contacts failed in shear at the peak (points / 2)"},
};

std::string path_of(const Column& column) { return std::string(schema::sensitivity_group) + "/" + column.name; }

}  // namespace

void write_sensitivity(H5Output& file, const std::vector<SensitivityRow>& rows) {
    file.create_group(schema::sensitivity_group);
    std::vector<std::string> changed;
    for (const SensitivityRow& row : rows) changed.push_back(row.changed);
    file.attribute(schema::sensitivity_group, "changed", changed);
    for (const Column& column : columns) {
        std::vector<double> values;
        for (const SensitivityRow& row : rows) values.push_back(row.*column.member);
        file.write<double>(path_of(column), std::span<const double>(values), {values.size()}, si_unit(column.dimension),
                           column.description);
    }
}

std::vector<SensitivityRow> read_sensitivity(const H5Input& file) {
    if (!file.has(schema::sensitivity_group)) return {};
    std::vector<SensitivityRow> rows;
    for (const std::string& changed : file.attribute<std::vector<std::string>>(schema::sensitivity_group, "changed")) {
        rows.push_back({changed, 0, 0, 0, 0, 0});
    }
    for (const Column& column : columns) {
        const std::vector<double> values = file.read<double>(path_of(column), {rows.size()});  // NaN if a value does not apply
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*column.member = values[i];
    }
    return rows;
}

}  // namespace graincrack
