// HTML without anything outside the page: text, tables, pictures in place.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"

namespace graincrack::html {

std::string escaped(const std::string& text);
std::string base64(const std::vector<unsigned char>& bytes);

/// A table; cells are text, escaped here. An empty cell shows as a dash.
class Table {
public:
    /// \param wraps long cells are broken into lines
    explicit Table(std::vector<std::string> columns, bool wraps = false) : columns_(std::move(columns)), wraps_(wraps) {}
    /// \param kind of the row, for the style sheet; "" for none
    void row(std::vector<std::string> cells, std::string kind = "") { rows_.push_back({std::move(cells), std::move(kind)}); }
    /// A row whose second cell holds for all other columns.
    void row_for_all(const std::string& first, const std::string& second) { rows_.push_back({{first, second}, ""}); }
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

/// Figures in two columns, in one where the window is narrow. Of an odd number the first stands across both, so that no column
/// is left empty; a map of a specimen, which is not wide, in their middle.
class Figures {
public:
    /// \param draw is called once, by `str`
    void add(const std::string& caption, std::function<Drawing(const PictureStyle&)> draw) {
        figures_.push_back({caption, std::move(draw), std::nullopt});
    }
    void add_map(const std::string& caption, Drawing map) { figures_.push_back({caption, {}, std::move(map)}); }
    [[nodiscard]] bool empty() const { return figures_.empty(); }
    [[nodiscard]] std::string str() const;
    /// The same under a heading of their own, on one page of a print.
    [[nodiscard]] std::string under(const std::string& heading) const;

private:
    struct Figure {
        std::string caption;
        std::function<Drawing(const PictureStyle&)> draw;
        std::optional<Drawing> map;
    };
    std::vector<Figure> figures_;
};

/// The figures that a report begins with, up to three side by side, one below the other where the window is narrow.
class FirstFigures {
public:
    /// \param place of the section with more of it
    void add(const std::string& caption, const std::string& place, std::function<Drawing(const PictureStyle&)> draw) {
        figures_.push_back({caption, place, std::move(draw)});
    }
    [[nodiscard]] std::string str() const;

private:
    struct Figure {
        std::string caption;
        std::string place;
        std::function<Drawing(const PictureStyle&)> draw;
    };
    std::vector<Figure> figures_;
};

/// A section with a heading; `id` is its place for links.
std::string section(const std::string& id, const std::string& heading, const std::string& content);
/// \param kind for the style sheet; "" for none
std::string paragraph(const std::string& text, const std::string& kind = "");
/// A paragraph that leads to a file. \param path relative to the page
std::string link(const std::string& path, const std::string& text);
/// Content that is shown when its summary is clicked, and in a print.
std::string details(const std::string& summary, const std::string& content);

/// The whole page.
std::string page(const std::string& title, const std::string& body);

/// Four significant digits, "" for what is not finite.
std::string number(double value, int digits = 4);

}  // namespace graincrack::html
