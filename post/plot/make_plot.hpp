// A picture as a command of `plot`: its file name is checked before the drawing begins.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture.hpp"
#include "post/command.hpp"
#include "post/option_parts.hpp"

namespace graincrack {

/// The options of every picture; a picture with options of its own derives from it.
struct PlotOptions {
    std::string picture;  ///< .png, .svg or .pdf
    PictureSize size;
};
/// -o, --width, --dpi
void add_picture(CLI::App& app, PlotOptions& options);

/// A picture with options; `add` declares them, the file of the picture by `add_picture` among them.
template <class Options>
Command make_plot(std::string name, std::string help, std::vector<std::string> examples, std::optional<FileArguments> files,
                  const std::function<void(CLI::App&, Options&)>& add,
                  const std::function<Drawing(const Options&, const Call&)>& draw) {
    return make_command<Options>(std::move(name), std::move(help), std::move(examples), files, add,
                                 [draw](const Options& options, const Call& call) {
                                     require_picture(options.picture, options.size);
                                     write_picture(draw(options, call), options.picture, options.size);
                                 });
}

/// A picture without options of its own.
inline Command make_plot(std::string name, std::string help, std::vector<std::string> examples,
                         std::optional<FileArguments> files, const std::function<Drawing(const Call&)>& draw) {
    return make_plot<PlotOptions>(std::move(name), std::move(help), std::move(examples), files, add_picture,
                                  [draw](const PlotOptions&, const Call& call) { return draw(call); });
}

}  // namespace graincrack
