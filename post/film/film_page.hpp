// One picture of a film: the map of the specimen beside its stress–strain curve.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/map_view.hpp"
#include "post/chart/picture.hpp"
#include "post/chart/picture_style.hpp"
#include "post/film/moments.hpp"
#include "post/plot/crack_state.hpp"
#include "post/run/crack_label.hpp"

namespace graincrack {

/// By what a film advances evenly.
enum class FilmSteps { strain, time };

/// Contents and form of a film.
struct FilmContents {
    FilmSteps steps = FilmSteps::strain;
    ImageSize size{1280, 720};
    double magnification = 1;  ///< of the displacements
    CrackLabelChoice label = {};
    std::vector<std::string> classes = {};  ///< of the contacts whose cracks are shown
    std::string title;                      ///< empty: that of the test
};

class FilmPage {
public:
    /// Reads the run; all frames once, for what is to be seen in any of them. \throws InputError if the run has fewer than two
    /// frames of different times, was not loaded, or does not advance; UsageError as `contacts_of_classes`; Interrupted
    FilmPage(const RunReader& run, FilmContents contents);
    FilmPage(const FilmPage&) = delete;
    FilmPage& operator=(const FilmPage&) = delete;

    /// Times of `count` pictures, s.
    [[nodiscard]] std::vector<double> moments(std::size_t count) const;
    /// The picture of a time.
    Drawing at(double time);

private:
    Drawing map_at(double time, const std::vector<Crack>& present);
    double draw_foot(Drawing& page, double top) const;
    [[nodiscard]] Drawing stress_chart(double time, double height) const;
    [[nodiscard]] TextColumn column() const;

    FilmContents contents_;
    Specimen specimen_;
    std::vector<Crack> cracks_;  ///< labelled, of the wanted classes
    RunData data_;               ///< its history counts these cracks
    LoadCurve curve_;
    Passage passage_;
    std::vector<double> frame_times_;
    std::vector<std::string> notes_;
    Motion motion_;
    std::optional<PlatenFaceSet> platens_;
    MapBox view_;
    double page_width_;
    double map_width_ = 0;  ///< of the column with the map, in pixels of the drawing
};

}  // namespace graincrack
