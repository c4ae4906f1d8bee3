// Settings of every picture beside its file: width of the page, title, legend texts of runs, limits of axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace graincrack {

/// Values that an axis spans, in its unit.
struct AxisLimits {
    double low = 0;
    double high = 1;
    std::string text;  ///< the option and what was written, for messages
};
/// Reads "0,0.4". \param option what messages name \throws UsageError
AxisLimits parse_limits(const std::string& text, const std::string& option);

/// A text in the legend in place of a run's own.
struct RunLabel {
    std::string run;  ///< as the file was given, or its name with or without its ending
    std::string text;
};
/// Reads "uniaxial.h5=dry". \throws UsageError
RunLabel parse_run_label(const std::string& text);

struct PictureStyle {
    /// Width of the page in pixels of the drawing. Letters have a fixed number of them, so that they grow less than a picture.
    double page_width = 1000;
    std::string title;             ///< empty: the picture's own
    std::vector<RunLabel> labels;  ///< of runs
    std::optional<AxisLimits> x_limits;
    std::optional<AxisLimits> y_limits;

    /// The text that was given for a file; empty without one.
    [[nodiscard]] std::string label_of(const std::string& file) const;
    /// \throws UsageError if a label names none of the files
    void require_labels_of(const std::vector<std::string>& files) const;
    /// The same for a part of a picture: without its title, of another width.
    [[nodiscard]] PictureStyle of_part(double width) const;
};

/// The page for a picture that is so wide on paper, m: letters have 6 to 7 pt at 84 mm and 8 to 10 pt at 174 mm.
double page_width_on_paper(double width);

}  // namespace graincrack
