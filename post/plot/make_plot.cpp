#include "post/plot/make_plot.hpp"

#include <algorithm>

#include "post/chart/axis.hpp"
#include "post/options/command.hpp"
#include "share/base/quantities.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

void add_limits(OptionSet set, const std::string& option, std::optional<AxisLimits>& limits, const std::string& what) {
    add_value(
        set.seldom(), option, [&limits, option](const std::string& text) { limits = parse_limits(text, option); },
        what + " in its unit, such as 0,0.4; what lies outside is cut off", "LOW,HIGH", "");
}

}  // namespace

void add_picture(OptionSet set, PlotOptions& options) {
    static constexpr Quantity width{"width", Dimension::length, 0.04, 2, "width of a picture on paper"};
    static constexpr Quantity resolution{"dpi", Dimension::one, 10, 2400, "pixels of a PNG to an inch"};
    add_output(set, options.picture, "picture: .png, .svg or .pdf", {".png", ".svg", ".pdf"});
    add_quantity(set, "--width", options.size.width, width,
                 "width on paper; letters of 6 to 7 pt in a column of 84 mm, of 8 to 10 pt over two of 174 mm");
    add_quantity(set.seldom(), "--dpi", options.size.resolution, resolution,
                 "pixels of a PNG to an inch of --width (default: 300)");
    add_text(set, "--title", options.style.title, "title in place of the picture's own").type_name("TEXT");
}

void add_y_limits(OptionSet set, PlotOptions& options) { add_limits(set, "--y-limits", options.style.y_limits, "upright axis"); }

void add_chart(OptionSet set, PlotOptions& options) {
    add_picture(set, options);
    add_limits(set, "--x-limits", options.style.x_limits, "level axis");
    add_y_limits(set, options);
}

void add_labels(OptionSet set, PlotOptions& options) {
    add_texts(set, "--label", options.labels, "RUN=TEXT", "text in the legend for a file; may be given again");
}

PictureStyle style_of(const PlotOptions& options, const std::vector<std::string>& files) {
    PictureStyle style = options.style;
    const bool is_pdf = options.picture.ends_with(".pdf");
    if (options.size.width || is_pdf) style.page_width = page_width_on_paper(options.size.width.value_or(pdf_width));
    for (const std::string& label : options.labels) style.labels.push_back(parse_run_label(label));
    style.require_labels_of(files);
    return style;
}

}  // namespace graincrack
