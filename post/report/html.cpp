#include "post/report/html.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "post/chart/page.hpp"
#include "post/chart/picture.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::html {

namespace {

const char* const style_sheet = R"css(
:root { color-scheme: light; }
body { font: 15px/1.45 "Liberation Sans", Arial, Helvetica, sans-serif; color: #1e1e1e; background: #fff; margin: 0 auto;
       max-width: 1160px; padding: 24px; }
h1 { font-size: 26px; margin: 0 0 4px; }
h2 { font-size: 20px; margin: 32px 0 8px; padding-top: 10px; border-top: 2px solid #1e1e1e; }
h3 { font-size: 16px; margin: 14px 0 4px; }
p { margin: 6px 0; }
p.lead { color: #555; }
table { border-collapse: collapse; margin: 8px 0 16px; font-size: 14px; font-variant-numeric: tabular-nums; }
th { text-align: left; border-bottom: 1.5px solid #1e1e1e; padding: 3px 12px 3px 0; vertical-align: bottom; cursor: pointer; }
th[aria-sort=ascending]::after { content: "\a0▲"; font-size: 9px; }
th[aria-sort=descending]::after { content: "\a0▼"; font-size: 9px; }
td { border-bottom: 1px solid #ddd; padding: 3px 12px 3px 0; vertical-align: top; }
th, td:not(:first-child) { white-space: pre-line; }
.long td:last-child { overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
.checks { background: #f4f6f8; border-left: 6px solid #0072b2; padding: 4px 16px 8px; }
.columns { display: grid; grid-template-columns: repeat(2, minmax(0, 1fr)); gap: 0 32px; align-items: start; }
.figures { column-count: 2; column-gap: 32px; }
.figures .across, .figures .middle { column-span: all; }
.columns > div:only-child { grid-column: 1 / -1; }
figure { margin: 6px 0 14px; min-width: 0; max-width: 564px; break-inside: avoid; }
figure.across { max-width: none; }
figure.middle { margin-left: auto; margin-right: auto; }
figure img { width: 100%; height: auto; display: block; border: 1px solid #ddd; box-sizing: border-box; }
figcaption { font-size: 14px; color: #555; margin-top: 4px; }
img { max-width: 100%; }
.first { display: grid; gap: 0 24px; align-items: start; margin: 14px 0 0; }
.first.of2 { grid-template-columns: repeat(2, minmax(0, 1fr)); }
.first.of3 { grid-template-columns: repeat(3, minmax(0, 1fr)); }
.first a { color: inherit; }
tr.within td:nth-child(5) { color: #00694b; font-weight: bold; }
tr.outside td:nth-child(5) { color: #a83c00; font-weight: bold; }
tr.untested td { color: #666; }
details { margin: 8px 0; }
summary { cursor: pointer; font-weight: bold; }
@media (max-width: 860px) { .columns, .first.of2, .first.of3 { grid-template-columns: minmax(0, 1fr); } .figures { column-count: 1; } }
@media (max-width: 500px) { body { padding: 12px; } table { font-size: 12px; } th, td { padding-right: 5px; } }
@page { size: A4; margin: 14mm; }
@media print { body { max-width: none; padding: 0; font-size: 10pt; } table, figcaption { font-size: 9pt; }
       .columns { grid-template-columns: minmax(0, 1fr); } .columns table { font-size: 8pt; } .figures { column-count: 2; }
       h2, h3, summary { break-after: avoid; }
       .first.of2 { grid-template-columns: repeat(2, minmax(0, 1fr)); } .first.of3 { grid-template-columns: repeat(3, minmax(0, 1fr)); }
       details::details-content { content-visibility: visible; } .wide { overflow: visible; }
       figure, tr, .kind { break-inside: avoid; } figure img { max-height: 220mm; object-fit: contain; } }
)css";

// A click on the head of a column, or Enter, sorts the rows by it: by numbers, which stand before words, or by words; another one
// turns the order round. Empty entries stay last. Rows that do not repeat their first entry get it.
const char* const script = R"js(
const sort = event => {
  const head = event.target.closest("th");
  if (!head || (event.key ?? "Enter") != "Enter") return;
  const column = head.cellIndex, up = head.ariaSort != "ascending", rows = [...head.closest("table").rows].slice(1);
  for (const other of head.parentNode.cells) other.ariaSort = null;
  head.ariaSort = up ? "ascending" : "descending";
  rows.forEach((row, i) => { if (i && !row.cells[0].textContent.trim()) row.cells[0].textContent = rows[i - 1].cells[0].textContent; });
  const text = row => (row.cells[column] ?? row.lastElementChild).textContent.trim().replace(/^[–-]$/, "").replace("−", "-");
  const order = (a, b) => {
    const [m, n] = [parseFloat(a), parseFloat(b)];
    if (!a || !b) return (up ? 1 : -1) * (!a - !b);
    return isNaN(m) - isNaN(n) || m - n || a.localeCompare(b, "en", {numeric: true});
  };
  rows.sort((a, b) => (up ? 1 : -1) * order(text(a), text(b)));
  for (const row of rows) row.parentNode.append(row);
};
for (const head of document.querySelectorAll("th")) head.tabIndex = 0;
for (const kind of ["click", "keydown"]) document.addEventListener(kind, sort);
)js";

}  // namespace

std::string base64(const std::vector<unsigned char>& bytes) {
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k) word = (word << 8) | (k < left ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k) out += k <= left ? letters[(word >> (18 - 6 * k)) & 63U] : '=';
    }
    return out;
}

namespace {

std::string image(const Drawing& drawing, const std::string& caption) {
    constexpr std::size_t many_marks = 2500;
    constexpr std::size_t long_svg = 150'000;  // bytes, about those of the PNG
    const std::string svg = drawing.n_marks() < many_marks ? to_svg(drawing) : "";
    const bool is_svg = !svg.empty() && svg.size() < long_svg;
    // As data of an image: several SVG elements in a page would share the names of their letters.
    return fmt::format("<img alt=\"{}\" src=\"data:image/{};base64,{}\">", escaped(caption + ": " + drawing.words()),
                       is_svg ? "svg+xml" : "png",
                       base64(is_svg ? std::vector<unsigned char>(svg.begin(), svg.end()) : png_bytes(drawing)));
}

}  // namespace

std::string escaped(const std::string& text) { return escape_xml(text); }

std::string Table::str() const {
    std::string out = fmt::format("<div class=\"wide\"><table{}>\n<thead><tr>", wraps_ ? " class=\"long\"" : "");
    for (const std::string& column : columns_) out += "<th>" + escaped(column) + "</th>";
    out += "</tr></thead>\n<tbody>\n";
    for (const auto& [row, kind] : rows_) {
        out += kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool last_of_few = i + 1 == row.size() && row.size() < columns_.size();
            out += last_of_few ? fmt::format("<td colspan=\"{}\">", columns_.size() - i) : "<td>";
            out += (row[i].empty() ? "–" : escaped(row[i])) + "</td>";
        }
        out += "</tr>\n";
    }
    return out + "</tbody></table></div>\n";
}

PictureStyle figure_style(bool wide) { return figure_style_of(wide ? 1110 : 540); }

PictureStyle figure_style_of(double pixels) {
    constexpr double pixels_of_letters = 13.5;  // as in tables
    PictureStyle style;
    style.page_width = std::round(pixels * letters::text / pixels_of_letters);
    return style;
}

std::string figure(const Drawing& drawing, const std::string& caption, FigurePlace place) {
    const char* const style = place == FigurePlace::across   ? " class=\"across\""
                              : place == FigurePlace::middle ? " class=\"middle\""
                                                             : "";
    return fmt::format("<figure{}>{}<figcaption>{}</figcaption></figure>\n", style, image(drawing, caption), escaped(caption));
}

std::string Figures::str() const {
    std::string content;
    bool odd = figures_.size() % 2 == 1;
    for (const Figure& each : figures_) {
        const FigurePlace place = !odd ? FigurePlace::column : each.map ? FigurePlace::middle : FigurePlace::across;
        odd = false;
        content += figure(each.map ? *each.map : each.draw(figure_style(place == FigurePlace::across)), each.caption, place);
    }
    return "<div class=\"figures\">\n" + content + "</div>\n";
}

std::string Figures::under(const std::string& heading) const {
    return "<div class=\"kind\"><h3>" + escaped(heading) + "</h3>\n" + str() + "</div>\n";
}

std::string FirstFigures::str() const {
    if (figures_.empty()) return "";
    std::string content;
    for (const Figure& each : figures_) {
        const Drawing drawing = each.draw(figure_style_of(figures_.size() < 3 ? 480 : 350));
        content += fmt::format("<figure>{}<figcaption><a href=\"#{}\">{}</a></figcaption></figure>\n",
                               image(drawing, each.caption), each.place, escaped(each.caption));
    }
    return fmt::format("<div class=\"first of{}\">\n{}</div>\n", figures_.size(), content);
}

std::string section(const std::string& id, const std::string& heading, const std::string& content) {
    return fmt::format("<h2 id=\"{}\">{}</h2>\n{}", id, escaped(heading), content);
}

std::string paragraph(const std::string& text, const std::string& kind) {
    return (kind.empty() ? "<p>" : "<p class=\"" + kind + "\">") + escaped(text) + "</p>\n";
}

std::string link(const std::string& path, const std::string& text) {
    std::string address;
    for (const unsigned char c : path) {
        const bool is_plain = (std::isalnum(c) != 0 && c < 0x80) || std::strchr("-_.~/", c) != nullptr;
        address += is_plain ? std::string(1, static_cast<char>(c)) : fmt::format("%{:02X}", c);
    }
    return "<p><a href=\"" + address + "\">" + escaped(text) + "</a></p>\n";
}

std::string details(const std::string& summary, const std::string& content) {
    return "<details><summary>" + escaped(summary) + "</summary>\n" + content + "</details>\n";
}

std::string page(const std::string& title, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, "
        "initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}<script>{}</script>\n</body>\n</html>\n",
        escaped(title), style_sheet, body, script);
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "";
    // Plain decimals, no powers of ten, also for a large number of few digits such as a deviation of 113 at two digits.
    if (std::abs(value) >= std::pow(10, digits) && std::abs(value) < 1e7) return fmt::format("{:.0f}", value);
    return format_number(value == 0 ? 0.0 : value, digits);
}

}  // namespace graincrack::html
