#include "post/plot/make_plot.hpp"

#include "share/command_line.hpp"
#include "share/quantities.hpp"

namespace graincrack {

void add_picture(CLI::App& app, PlotOptions& options) {
    static constexpr Quantity width{"width", Dimension::length, 0.01, 2, "width of a picture on paper"};
    static constexpr Quantity resolution{"dpi", Dimension::one, 10, 2400, "pixels of a PNG to an inch"};
    add_output(app, options.picture, "picture: .png, .svg or .pdf");
    add_quantity(app, "--width", options.size.width, width, "width on paper; letters grow and shrink with it");
    add_quantity(app, "--dpi", options.size.resolution, resolution, "pixels of a PNG to an inch of --width (default: 300)");
}

}  // namespace graincrack
