// Settings of every picture apart from its file: page width, title, legend texts of runs, limits of axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace graincrack {

/// Range of an axis, in its unit.
struct AxisLimits {
    double low = 0;
    double high = 1;
    std::string text;  ///< option and text as given, for messages
};
/// Reads "0,0.4". \param option its name in messages \throws UsageError
AxisLimits parse_limits(const std::string& text, const std::string& option);

/// A legend text that replaces a run's own.
struct RunLabel {
    std::string run;  ///< file as given, or its name with or without its ending
    std::string text;
};
/// Reads "uniaxial.h5=dry". \throws UsageError
RunLabel parse_run_label(const std::string& text);

struct PictureStyle {
    /// Width of the page in pixels of the drawing. Letters have a fixed number of pixels, so that they grow less than a picture.
    double page_width = 1000;
    std::string title;             ///< empty: the default of the picture
    std::vector<RunLabel> labels;  ///< labels of runs
    std::optional<AxisLimits> x_limits;
    std::optional<AxisLimits> y_limits;

    /// The label given for a file; empty without one.
    [[nodiscard]] std::string label_of(const std::string& file) const;
    /// Checks the labels. \throws UsageError if one names none of the files
    void require_labels_of(const std::vector<std::string>& files) const;
    /// The style of a part of a picture: without title, with another width.
    [[nodiscard]] PictureStyle of_part(double width) const;
};

/// Page width in pixels for a picture of a width on paper, m: letters have 6 to 7 pt at 84 mm and 8 to 10 pt at 174 mm.
double page_width_on_paper(double width);

}  // namespace graincrack
