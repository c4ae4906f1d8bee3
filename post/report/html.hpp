// HTML without anything outside the page: text, tables, pictures in place.
#pragma once

#include <string>
#include <vector>

#include "post/chart/drawing.hpp"

namespace graincrack::html {

std::string escaped(const std::string& text);

/// A table; cells are text, escaped here. An empty cell shows as a dash.
class Table {
public:
    /// \param wraps long cells are broken into lines
    explicit Table(std::vector<std::string> columns, bool wraps = false) : columns_(std::move(columns)), wraps_(wraps) {}
    void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }
    [[nodiscard]] bool empty() const { return rows_.empty(); }
    [[nodiscard]] std::string str() const;

private:
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
    bool wraps_;
};

/// A picture with a caption: as SVG, or, where many shapes would make that long, as PNG.
std::string figure(const Drawing& drawing, const std::string& caption, bool wide = false);

/// A section with a heading; `id` is its place for links.
std::string section(const std::string& id, const std::string& heading, const std::string& content);
std::string paragraph(const std::string& text);

/// The whole page.
std::string page(const std::string& title, const std::string& body);

/// Four significant digits, "" for what is not finite.
std::string number(double value, int digits = 4);

}  // namespace graincrack::html
