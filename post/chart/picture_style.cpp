#include "post/chart/picture_style.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "post/table/table.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

bool names(const RunLabel& label, const std::string& file) {
    const std::filesystem::path path(file);
    return label.run == file || label.run == path.filename().string() || label.run == path.stem().string();
}

}  // namespace

AxisLimits parse_limits(const std::string& text, const std::string& option) {
    const std::string where = option + " " + text;
    const std::size_t comma = text.find(',');
    const auto number = [](std::string_view part) {
        const auto value = parse_number(std::string(trimmed(part)));
        return value && std::isfinite(*value) ? value : std::nullopt;
    };
    const auto low = number(std::string_view(text).substr(0, comma));
    const auto high = comma == std::string::npos ? std::nullopt : number(std::string_view(text).substr(comma + 1));
    if (!low || !high) throw UsageError(where + ": needs two numbers in the unit of the axis; 0,0.4 fits");
    if (!(*low < *high)) throw UsageError(where + ": the first number must be below the second");
    return {*low, *high, where};
}

RunLabel parse_run_label(const std::string& text) {
    const auto [run, label] = sides_of_equals(text);
    if (run.empty() || label.empty()) {
        throw UsageError("--label " + text + ": needs a run and its text; --label uniaxial.h5=dry fits");
    }
    return {run, label};
}

std::string PictureStyle::label_of(const std::string& file) const {
    const auto label = std::find_if(labels.begin(), labels.end(), [&](const RunLabel& l) { return names(l, file); });
    return label == labels.end() ? "" : label->text;
}

void PictureStyle::require_labels_of(const std::vector<std::string>& files) const {
    for (const RunLabel& label : labels) {
        const bool known = std::any_of(files.begin(), files.end(), [&](const std::string& file) { return names(label, file); });
        if (!known) {
            throw UsageError(
                fmt::format("--label {}: no file of this picture; one of {} fits", label.run, fmt::join(files, ", ")));
        }
    }
}

PictureStyle PictureStyle::of_part(double width) const {
    PictureStyle part = *this;
    part.page_width = width;
    part.title.clear();
    return part;
}

double page_width_on_paper(double width) {
    constexpr double column = 0.084;  // m, one column of most journals
    constexpr double of_column = 1000;
    const double share = width / column;
    return std::round(of_column * (share < 1 ? share : std::pow(share, 0.6)));
}

}  // namespace graincrack
