#include "post/chart/picture_style.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

/// A number and what follows it.
struct Value {
    double number = 0;
    std::string unit;
};

std::optional<Value> read_value(std::string text) {
    text.erase(0, text.find_first_not_of(' '));
    Value value;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value.number);
    if (error != std::errc{} || !std::isfinite(value.number)) return std::nullopt;
    value.unit = std::string(rest, end);
    value.unit.erase(0, value.unit.find_first_not_of(' '));
    return value;
}

bool names(const RunLabel& label, const std::string& file) {
    const std::filesystem::path path(file);
    return label.run == file || label.run == path.filename().string() || label.run == path.stem().string();
}

}  // namespace

AxisLimits parse_limits(const std::string& text, const std::string& option) {
    const std::string where = option + " " + text;
    const std::size_t comma = text.find(',');
    const auto low = comma == std::string::npos ? std::nullopt : read_value(text.substr(0, comma));
    const auto high = comma == std::string::npos ? std::nullopt : read_value(text.substr(comma + 1));
    if (!low || !high) throw UsageError(where + ": needs two numbers in the unit of the axis; 0,0.4 fits");
    if (!low->unit.empty() && low->unit != high->unit) throw UsageError(where + ": has two units; one behind the second fits");
    if (!(low->number < high->number)) throw UsageError(where + ": the first number must be below the second");
    return {low->number, high->number, high->unit, where};
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
