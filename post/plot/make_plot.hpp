// A picture as a command of `plot`: its file name is checked before the drawing begins.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/axis.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/picture.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// The options of every picture; a picture with options of its own derives from it.
struct PlotOptions {
    std::string picture;  ///< .png, .svg or .pdf
    PictureSize size;
    PictureStyle style;
    std::vector<std::string> labels;  ///< "RUN=TEXT", of --label
};
/// -o, --width, --dpi, --title
void add_picture(OptionSet set, PlotOptions& options);
/// The same for a picture with axes, with --x-limits and --y-limits.
void add_chart(OptionSet set, PlotOptions& options);
/// --y-limits alone, for a picture whose other axis has no numbers.
void add_y_limits(OptionSet set, PlotOptions& options);
/// --label RUN=TEXT, for a picture with runs in its legend.
void add_labels(OptionSet set, PlotOptions& options);

/// The style on a page that fits the size of the picture, with the labels of its files. \throws UsageError for another label
PictureStyle style_of(const PlotOptions& options, const std::vector<std::string>& files);

/// Draws a picture by its options and writes it; the name of its file is checked before.
template <class Options, class Draw>
void plot_picture(const Options& options, const std::vector<std::string>& files, const Draw& draw) {
    require_picture(options.picture, options.size);
    Options sized = options;
    sized.style = style_of(options, files);
    write_picture(draw(sized), options.picture, options.size);
}

/// A picture with options; `add` declares them, those of every picture by `add_picture` or `add_chart` among them.
template <class Options>
Command make_plot(std::string name, std::string help, std::vector<std::string> examples, std::optional<FileArguments> files,
                  const std::function<void(OptionSet, Options&)>& add,
                  const std::function<Drawing(const Options&, const Call&)>& draw) {
    return make_command<Options>(std::move(name), std::move(help), std::move(examples), files, add,
                                 [draw](const Options& options, const Call& call) {
                                     plot_picture(options, call.files, [&](const Options& sized) { return draw(sized, call); });
                                 });
}

}  // namespace graincrack
