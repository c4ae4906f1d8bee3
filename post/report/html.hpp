// HTML without anything outside the page: text, tables, pictures in place.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"

namespace graincrack::html {

std::string base64(const std::vector<unsigned char>& bytes);

/// A table; cells are text, escaped here. An empty cell shows as a dash.
class Table {
public:
    /// \param wraps long cells are broken into lines
    explicit Table(std::vector<std::string> columns, bool wraps = false) : columns_(std::move(columns)), wraps_(wraps) {}
    /// \param cells the last of fewer than there are columns holds for all others \param kind of the row, for the style sheet
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

/// The page of a picture in one column of the report, or across both: its letters are as large as those of tables.
PictureStyle figure_style(bool wide = false);
/// The same of a picture that is so many pixels wide on a screen.
PictureStyle figure_style_of(double pixels);
/// The position of a figure among others.
enum class FigurePlace { column, across, middle };
/// A picture with a caption: as SVG, or, where many shapes would make that long, as PNG.
std::string figure(const Drawing& drawing, const std::string& caption, FigurePlace place = FigurePlace::column);
/// A map of a run that `map.js` draws. \param run of those that the page holds \param frame of those of the run \param height
/// pixels
std::string map_figure(std::size_t run, std::size_t frame, int height);

/// Figures in two columns, in one where the window is narrow. Of an odd number the first stands across both, so that no column
/// is left empty; a specimen, which is not wide, in their middle.
class Figures {
public:
    using Draw = std::function<Drawing(const PictureStyle&)>;
    /// \param draw is called once, by `str` or `first` \param place of the section with more of it, to which its caption leads
    void add(const std::string& caption, Draw draw, const std::string& place = "") {
        figures_.push_back({caption, std::move(draw), place, "", false});
    }
    void add_specimen(const std::string& caption, Draw draw) { figures_.push_back({caption, std::move(draw), "", "", true}); }
    void add_map(const std::string& figure) { figures_.push_back({"", {}, "", figure, true}); }
    [[nodiscard]] bool empty() const { return figures_.empty(); }
    [[nodiscard]] std::string str() const;
    /// The same under a heading of their own, on one page of a print.
    [[nodiscard]] std::string under(const std::string& heading) const;
    /// Up to three side by side, with which a report begins.
    [[nodiscard]] std::string first() const;

private:
    struct Figure {
        std::string caption;
        Draw draw;
        std::string place;
        std::string map;  ///< as `map_figure`, in place of what `draw` draws
        bool is_narrow = false;
    };
    std::vector<Figure> figures_;
};

/// A section with a heading; `id` is its place for links.
std::string section(const std::string& id, const std::string& heading, const std::string& content);
/// \param kind for the style sheet; "" for none
std::string paragraph(const std::string& text, const std::string& kind = "");
/// The whole page. \param maps scripts that its maps need, as `map_scripts`
std::string page(const std::string& title, const std::string& body, const std::string& maps);

/// Four significant digits, "" for what is not finite.
std::string number(double value, int digits = 4);

}  // namespace graincrack::html
