// Writes HTML pages that need no other file: text, tables and embedded pictures.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"

namespace graincrack::html {

std::string base64(const std::vector<unsigned char>& bytes);

/// A table. Cells are plain text, which is escaped here; an empty cell shows a dash.
class Table {
public:
    /// \param wraps true if long cells are broken into lines
    explicit Table(std::vector<std::string> columns, bool wraps = false) : columns_(std::move(columns)), wraps_(wraps) {}
    /// Adds a row. \param cells if fewer than columns, the last one spans all others \param kind class of the style sheet
    void row(std::vector<std::string> cells, std::string kind = "") { rows_.push_back({std::move(cells), std::move(kind)}); }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] std::string str() const;

private:
    struct Row {
        std::vector<std::string> cells;
        std::string kind;
    };
    std::vector<std::string> columns_;
    std::vector<Row> rows_;
    bool wraps_;
};

/// The style of a picture in one column of the report, or across both; its letters are as large as those of tables.
PictureStyle figure_style(bool wide = false);
/// The style of a picture of this width on a screen, pixels.
PictureStyle figure_style_of(double pixels);
/// The position of a figure among others.
enum class FigurePlace { column, across, middle };
/// A picture with a caption, as SVG or, if many shapes would make that long, as PNG.
std::string figure(const Drawing& drawing, const std::string& caption, FigurePlace place = FigurePlace::column);
/// A map of a run, drawn by `map.js`. \param run index among the runs of the page \param frame index among the frames that the
/// page has of the run \param height pixels
std::string map_figure(std::size_t run, std::size_t frame, int height);

/// Figures in two columns, or in one if the window is narrow. If their number is odd, the first one spans both columns, so that
/// no column is left empty; a specimen, which is not wide, stands in their middle.
class Figures {
public:
    using Draw = std::function<Drawing(const PictureStyle&)>;
    /// \param draw is called once, by `str` or `first` \param place id of a section with details, to which the caption links
    void add(const std::string& caption, Draw draw, const std::string& place = "") {
        figures_.push_back({caption, std::move(draw), place, "", false});
    }
    void add_specimen(const std::string& caption, Draw draw) { figures_.push_back({caption, std::move(draw), "", "", true}); }
    void add_map(const std::string& figure) { figures_.push_back({"", {}, "", figure, true}); }
    [[nodiscard]] bool empty() const { return figures_.empty(); }
    [[nodiscard]] std::string str() const;
    /// The figures under a heading of their own, on one printed page.
    [[nodiscard]] std::string under(const std::string& heading) const;
    /// Up to three figures side by side, for the start of a report.
    [[nodiscard]] std::string first() const;

private:
    struct Figure {
        std::string caption;
        Draw draw;
        std::string place;
        std::string map;  ///< result of `map_figure`, instead of `draw`
        bool is_narrow = false;
    };
    std::vector<Figure> figures_;
};

/// A section with a heading; links use its `id`.
std::string section(const std::string& id, const std::string& heading, const std::string& content);
/// A paragraph. \param kind class of the style sheet; "" for none
std::string paragraph(const std::string& text, const std::string& kind = "");
/// The whole page. \param maps scripts of its maps, from `map_scripts`
std::string page(const std::string& title, const std::string& body, const std::string& maps);

/// A number with so many significant digits; "" if it is not finite.
std::string number(double value, int digits = 4);

}  // namespace graincrack::html
