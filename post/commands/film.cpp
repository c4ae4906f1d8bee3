#include "post/commands/film.hpp"

#include "post/cracks/crack_options.hpp"
#include "post/film/film.hpp"
#include "post/options/common_options.hpp"
#include "share/base/quantities.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

Command film_command() {
    static constexpr Quantity duration{"duration", Dimension::time, 0, 3600, "how long a film runs", true};
    static constexpr Quantity magnification{"magnify", Dimension::one, 0, 1e6, "factor on displacements"};
    return make_command<FilmOptions>(
        "film", "a film of a test: crack map beside the stress-strain curve, as MP4, WebM or PNG",
        {"uniaxial.h5 -o uniaxial.mp4 --duration 2s --size 640x480", "brazilian.h5 -o frames --by time --frames-per-second 2"},
        one_run,
        [](OptionSet set, FilmOptions& options) {
            add_output(set, options.output,
                       "film: .mp4 (H.264) or .webm (VP9), which ffmpeg encodes, or a folder of numbered PNG");
            add_choice<FilmSteps>(
                set, "--by", options.contents.steps, {{"strain", FilmSteps::strain}, {"time", FilmSteps::time}},
                "what pictures are even steps of: axial strain, or time, which shows slowly what happens at the peak; between "
                "the stored frames of the run displacements are linear in it, and cracks appear at their own times");
            add_quantity(set, "--duration", options.duration, duration, "how long the film runs", "10s");
            add_integer(set, "--frames-per-second", options.frames_per_second, "pictures in a second", 1, 120);
            add_value(
                set, "--size", [&options](const std::string& text) { options.contents.size = parse_film_size(text); },
                "pixels of a picture, both even, 1.3 to 3 times as wide as high", "WIDTHxHEIGHT", "1280x720");
            add_quantity(set, "--magnify", options.contents.magnification, magnification,
                         "draw displacements so many times as large", "1");
            add_text(set, "--title", options.contents.title, "title in place of the film's own").type_name("TEXT");
            add_crack_label(set, options.contents.label);
            add_classes(set, options.contents.classes);
        },
        make_film);
}

}  // namespace graincrack
