#include "post/chart/font.hpp"

#include <pango/pangocairo.h>

#include <cstdlib>
#include <memory>
#include <numbers>

#include "share/base/shared_file.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

struct FreePango {
    void operator()(gpointer object) const { g_object_unref(object); }
    void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
template <class T>
using Owned = std::unique_ptr<T, FreePango>;

/// Letters have the same shape and distance at every resolution, so that measured widths hold in each file. An installation for
/// machines without fonts brings its own, with the file that lists them.
Owned<PangoContext> make_context() {
    const std::filesystem::path fonts = SharedFolder{.what = "font", .folder = "fonts"}.below("fonts.conf");
    if (!fonts.empty()) setenv("FONTCONFIG_FILE", fonts.c_str(), 0);
    Owned<PangoContext> context(pango_font_map_create_context(pango_cairo_font_map_get_default()));
    const Owned<cairo_font_options_t> options(cairo_font_options_create());
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    pango_cairo_context_set_font_options(context.get(), options.get());
    pango_cairo_context_set_resolution(context.get(), 72);
    pango_context_set_round_glyph_positions(context.get(), FALSE);
    return context;
}

/// Lays out one line of text.
Owned<PangoLayout> set_line(const std::string& label, double size, bool bold) {
    static const Owned<PangoContext> context = make_context();
    Owned<PangoLayout> layout(pango_layout_new(context.get()));
    const Owned<PangoFontDescription> font(pango_font_description_from_string("Liberation Sans,DejaVu Sans,sans-serif"));
    pango_font_description_set_absolute_size(font.get(), size * PANGO_SCALE);
    pango_font_description_set_weight(font.get(), bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
    const std::string shown = printable(label);
    const std::unique_ptr<char, decltype(&g_free)> valid(g_utf8_make_valid(shown.data(), static_cast<gssize>(shown.size())),
                                                         g_free);
    pango_layout_set_text(layout.get(), valid.get(), -1);
    return layout;
}

double width_of(PangoLayout* line) {
    PangoRectangle extent;
    pango_layout_get_extents(line, nullptr, &extent);
    return static_cast<double>(extent.width) / PANGO_SCALE;
}

}  // namespace

double text_width(const std::string& label, double size, bool bold) { return width_of(set_line(label, size, bold).get()); }

TextBox box_of(const Text& text) {
    const double width = text_width(text.label, text.size, text.bold);
    const double before = width * (text.anchor == Anchor::start ? 0 : text.anchor == Anchor::middle ? 0.5 : 1);
    const double rise = 0.75 * text.size;
    const double fall = 0.2 * text.size;
    if (text.upwards) return {text.at.x - rise, text.at.y - width + before, text.at.x + fall, text.at.y + before};
    return {text.at.x - before, text.at.y - rise, text.at.x - before + width, text.at.y + fall};
}

void show_text(cairo_t* context, const Text& text) {
    const Owned<PangoLayout> line = set_line(text.label, text.size, text.bold);
    const double before = text.anchor == Anchor::start ? 0 : text.anchor == Anchor::middle ? 0.5 : 1;
    cairo_save(context);
    cairo_translate(context, text.at.x, text.at.y);
    if (text.upwards) cairo_rotate(context, -std::numbers::pi / 2);
    cairo_move_to(context, -before * width_of(line.get()),
                  -static_cast<double>(pango_layout_get_baseline(line.get())) / PANGO_SCALE);
    cairo_set_source_rgb(context, text.colour.red / 255.0, text.colour.green / 255.0, text.colour.blue / 255.0);
    pango_cairo_show_layout(context, line.get());
    cairo_restore(context);
}

std::string pango_library_version() { return std::string("Pango ") + pango_version_string(); }

}  // namespace graincrack
