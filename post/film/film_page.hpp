// One picture of a film: the map of the specimen beside its stress–strain curve.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/map_view.hpp"
#include "post/chart/picture.hpp"
#include "post/chart/picture_style.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// By what a film advances evenly: a mixture of cracks and strain, strain, time.
enum class FilmSteps { cracks, strain, time };

/// Contents and form of a film.
struct FilmContents {
    FilmSteps steps = FilmSteps::cracks;
    ImageSize size{1280, 720};
    double magnification = 1;  ///< of the displacements
    CrackLabelChoice label = {};
    std::vector<std::string> classes = {};  ///< of the contacts whose cracks are shown
    std::string title;                      ///< empty: that of the test
};

/// Rows of a history in even steps of the distance that a quantity travels, so that cycles count both ways.
/// \param values of the quantity in the rows \pre first <= last, count > 1
std::vector<std::size_t> film_rows(const std::vector<double>& values, std::size_t first, std::size_t last, std::size_t count);
/// What pictures are even steps of, in each row. By cracks: three quarters of it are their number, the rest is the way of the
/// strain, so that the loading before the first crack is short; that of the strain alone in a test without cracks.
std::vector<double> film_way(FilmSteps steps, const History& history);

class FilmPage {
public:
    /// Reads the run; all frames once, for what is to be seen in any of them. \throws InputError if the run has fewer than two
    /// frames of different times, was not loaded, or does not advance; UsageError as `contacts_of_classes`; Interrupted
    FilmPage(const RunReader& run, FilmContents contents);
    FilmPage(const FilmPage&) = delete;
    FilmPage& operator=(const FilmPage&) = delete;

    /// Rows of the history that `count` pictures show, from the first frame to the last.
    [[nodiscard]] std::vector<std::size_t> rows(std::size_t count) const;
    /// The picture of a row of the history: cracks up to its time, grains as in the last frame before it.
    [[nodiscard]] Drawing at(std::size_t row) const;

private:
    [[nodiscard]] const std::vector<double>& times() const { return data_.history[HistoryColumn::time]; }
    /// The last row that is not behind a time.
    [[nodiscard]] std::size_t row_at(double time) const;
    [[nodiscard]] Positions nodes_in(std::size_t frame) const;
    [[nodiscard]] Drawing map_at(double time, const std::vector<Crack>& present) const;
    double draw_foot(Drawing& page, double top) const;
    [[nodiscard]] Drawing stress_chart(std::size_t row, double height) const;
    [[nodiscard]] TextColumn column() const;

    const RunReader& run_;
    FilmContents contents_;
    Specimen specimen_;
    std::vector<Crack> cracks_;  ///< labelled, of the wanted classes
    RunData data_;               ///< its history counts these cracks
    LoadCurve curve_;
    std::vector<double> way_;  ///< that the pictures are even steps of
    std::vector<double> frame_times_;
    std::vector<std::string> notes_;
    std::optional<PlatenFaceSet> platens_;
    MapBox view_;
    double page_width_;
    double map_width_ = 0;  ///< of the column with the map, in pixels of the drawing
};

}  // namespace graincrack
