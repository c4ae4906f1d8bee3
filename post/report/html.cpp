#include "post/report/html.hpp"

#include <fmt/format.h>
#include <glib.h>

#include <cmath>
#include <memory>

#include "post/chart/page.hpp"
#include "post/chart/picture.hpp"
#include "share/base/units.hpp"

namespace graincrack::html {

namespace {

// The files beside this one, as they stand there.
const char* const style_sheet =
#include "report.css.inc"
    ;
const char* const script =
#include "report.js.inc"
    ;

}  // namespace

std::string base64(const std::vector<unsigned char>& bytes) {
    const std::unique_ptr<gchar, decltype(&g_free)> letters(g_base64_encode(bytes.data(), bytes.size()), g_free);
    return letters.get();
}

namespace {

std::string image(const Drawing& drawing, const std::string& caption) {
    constexpr std::size_t many_marks = 2500;
    constexpr std::size_t long_svg = 150'000;  // bytes, about those of the PNG
    const std::string svg = drawing.n_marks() < many_marks ? to_svg(drawing) : "";
    const bool is_svg = !svg.empty() && svg.size() < long_svg;
    // As data of an image: several SVG elements in a page would share the names of their letters.
    return fmt::format("<img alt=\"{}\" src=\"data:image/{};base64,{}\">", escape_xml(caption + ": " + drawing.words()),
                       is_svg ? "svg+xml" : "png",
                       base64(is_svg ? std::vector<unsigned char>(svg.begin(), svg.end()) : png_bytes(drawing)));
}

}  // namespace

std::string Table::str() const {
    std::string out = fmt::format("<div class=\"wide\"><table{}>\n<thead><tr>", wraps_ ? " class=\"long\"" : "");
    for (const std::string& column : columns_) out += "<th>" + escape_xml(column) + "</th>";
    out += "</tr></thead>\n<tbody>\n";
    for (const auto& [row, kind] : rows_) {
        out += kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool last_of_few = i + 1 == row.size() && row.size() < columns_.size();
            out += last_of_few ? fmt::format("<td colspan=\"{}\">", columns_.size() - i) : "<td>";
            out += (row[i].empty() ? "–" : escape_xml(row[i])) + "</td>";
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
    return fmt::format("<figure{}>{}<figcaption>{}</figcaption></figure>\n", style, image(drawing, caption), escape_xml(caption));
}

std::string map_figure(std::size_t run, std::size_t frame, int height) {
    return fmt::format(
        "<figure class=\"map\" data-run=\"{}\" data-frame=\"{}\" data-height=\"{}\"><noscript>This map is drawn by JavaScript, "
        "which "
        "is off here.</noscript></figure>\n",
        run, frame, height);
}

std::string Figures::str() const {
    std::string content;
    bool odd = figures_.size() % 2 == 1;
    for (const Figure& each : figures_) {
        const FigurePlace place = !odd ? FigurePlace::column : each.is_narrow ? FigurePlace::middle : FigurePlace::across;
        content += each.draw ? figure(each.draw(figure_style(place == FigurePlace::across)), each.caption, place) : each.map;
        odd = odd && !each.draw;
    }
    return "<div class=\"figures\">\n" + content + "</div>\n";
}

std::string Figures::under(const std::string& heading) const {
    return "<div class=\"kind\"><h3>" + escape_xml(heading) + "</h3>\n" + str() + "</div>\n";
}

std::string Figures::first() const {
    std::string content;
    for (const Figure& each : figures_) {
        if (!each.draw) {
            content += each.map;
            continue;
        }
        const Drawing drawing = each.draw(figure_style_of(figures_.size() < 3 ? 480 : 350));
        content += fmt::format("<figure>{}<figcaption><a href=\"#{}\">{}</a></figcaption></figure>\n",
                               image(drawing, each.caption), each.place, escape_xml(each.caption));
    }
    return fmt::format("<div class=\"first of{}\">\n{}</div>\n", figures_.size(), content);
}

std::string section(const std::string& id, const std::string& heading, const std::string& content) {
    return fmt::format("<h2 id=\"{}\">{}</h2>\n{}", id, escape_xml(heading), content);
}

std::string paragraph(const std::string& text, const std::string& kind) {
    return (kind.empty() ? "<p>" : "<p class=\"" + kind + "\">") + escape_xml(text) + "</p>\n";
}

std::string page(const std::string& title, const std::string& body, const std::string& maps) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
        "content=\"width=device-width, "
        "initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}{}<script>{}</script>\n</body>\n</html>\n",
        escape_xml(title), style_sheet, body, maps, script);
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "";
    // Plain decimals, no powers of ten, also for a large number of few digits such as a deviation of 113 at two digits.
    if (std::abs(value) >= std::pow(10, digits) && std::abs(value) < 1e7) return fmt::format("{:.0f}", value);
    return format_number(value == 0 ? 0.0 : value, digits);
}

}  // namespace graincrack::html
