#include "post/picture/plot_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "post/test_words.hpp"
#include "share/error.hpp"
#include "share/units.hpp"

namespace graincrack {

namespace {

constexpr double left_margin = 130;
constexpr double right_margin = 60;
constexpr double right_margin_with_counts = 130;
constexpr double top_margin = 110;
constexpr double plot_width = 1140;
constexpr double plot_height = 760;
constexpr double bottom_margin = 130;
constexpr double legend_line = 36;
constexpr double label_size = 25;
constexpr double tick_size = 22;

/// A linear scale from values to pixels.
struct Scale {
    double low = 0;
    double high = 1;
    double from = 0;
    double to = 1;
    [[nodiscard]] double operator()(double value) const { return from + (value - low) / (high - low) * (to - from); }
    [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }
};

struct Run {
    const RunData* data;
    LoadCurve curve;
    std::vector<double> lateral;  ///< widening negative in compression, narrowing negative in tension
};

std::string kind_of(const RunData& run) {
    const bool compression = run.header.test == "uniaxial" || run.header.test == "triaxial";
    return compression ? "compression" : run.header.test;
}

std::vector<Run> prepare(const std::vector<RunData>& data) {
    std::vector<Run> runs;
    for (const RunData& run : data) {
        if (kind_of(run) != kind_of(data.front())) {
            throw InputError(run.name + ": a " + run.header.test + " test cannot share a plot with " + data.front().name +
                             ", a " + data.front().header.test + " test; plot them apart");
        }
        Run prepared{&run, load_curve(run), {}};
        prepared.lateral = prepared.curve.lateral_strain;
        if (run.header.test != "tension") {
            for (double& strain : prepared.lateral) strain = -strain;
        }
        runs.push_back(std::move(prepared));
    }
    return runs;
}

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

/// The page: frame, scales, ticks; curves are added by the callers.
class CurvePage {
public:
    CurvePage(const std::vector<Run>& runs, std::size_t legend_lines)
        : drawing_(static_cast<int>(left_margin + plot_width + (runs.size() == 1 ? right_margin_with_counts : right_margin)),
                   static_cast<int>(top_margin + plot_height + bottom_margin + legend_line * static_cast<double>(legend_lines))) {
        double stress = 0;
        double strain = 0;
        double lateral = 0;
        for (const Run& run : runs) {
            stress = std::max(stress, run.curve.peak_stress());
            strain = std::max(strain, largest(run.curve.axial_strain));
            lateral = std::min(lateral, *std::min_element(run.lateral.begin(), run.lateral.end()));
        }
        // Rims that burst after the peak would squeeze the part that matters.
        lateral = std::max(lateral, -0.75 * strain);
        x_ = {110 * lateral, 105 * strain, left_margin, left_margin + plot_width};
        y_ = {0, 1.1e-6 * stress, top_margin + plot_height, top_margin};
    }

    Drawing& drawing() { return drawing_; }

    void draw_axes(const std::string& stress_label) {
        for (double tick : round_ticks(x_.low, x_.high, 8)) {
            drawing_.line({x_(tick), y_.from}, {x_(tick), y_.to}, 1, palette::faint);
            drawing_.text({{x_(tick), y_.from + 34}, tick_text(tick), tick_size, palette::ink, Anchor::middle});
        }
        for (double tick : round_ticks(y_.low, y_.high, 7)) {
            drawing_.line({x_.from, y_(tick)}, {x_.to, y_(tick)}, 1, palette::faint);
            drawing_.text({{x_.from - 14, y_(tick) + 8}, tick_text(tick), tick_size, palette::ink, Anchor::end});
        }
        drawing_.line({x_(0), y_.from}, {x_(0), y_.to}, 1.4, palette::rim);
        const double label_y = y_.from + 82;
        drawing_.text({{(x_(0) + x_.to) / 2, label_y}, "axial strain, %", label_size, palette::ink, Anchor::middle});
        if (x_(0) - x_.from > 150) {
            drawing_.text({{(x_.from + x_(0)) / 2, label_y}, "lateral strain, %", label_size, palette::ink, Anchor::middle});
        }
        drawing_.text({{44, (y_.from + y_.to) / 2}, stress_label, label_size, palette::ink, Anchor::middle, false, true});
    }

    void draw_frame() {
        drawing_.polyline({{x_.from, y_.from}, {x_.to, y_.from}, {x_.to, y_.to}, {x_.from, y_.to}, {x_.from, y_.from}}, 1.6,
                          palette::ink);
    }

    /// Counts of cracks against axial strain, on a scale of their own at the right.
    void draw_cracks(const Run& run) {
        const auto& tensile = run.data->history[HistoryColumn::tensile_cracks];
        const auto& shear = run.data->history[HistoryColumn::shear_cracks];
        const double most = std::max(largest(tensile), largest(shear));
        if (!(most > 0)) return;
        const Scale counts{0, 1.1 * most, y_.from, y_.to};
        for (double tick : round_ticks(0, counts.high, 6)) {
            if (tick != std::floor(tick)) continue;
            drawing_.line({x_.to, counts(tick)}, {x_.to + 8, counts(tick)}, 1.4, palette::ink);
            drawing_.text({{x_.to + 16, counts(tick) + 8}, tick_text(tick), tick_size});
        }
        drawing_.text({{x_.to + 110, (y_.from + y_.to) / 2},
                       "micro-cracks (contacts)",
                       label_size,
                       palette::ink,
                       Anchor::middle,
                       false,
                       true});
        draw_line(run.curve.axial_strain, 100, shear, 1, counts, 2.4, palette::shear);
        draw_line(run.curve.axial_strain, 100, tensile, 1, counts, 2.4, palette::tensile);
    }

    void draw_run(const Run& run, Colour colour) {
        draw_line(run.lateral, 100, run.curve.stress, 1e-6, y_, 3, colour);
        draw_line(run.curve.axial_strain, 100, run.curve.stress, 1e-6, y_, 4, colour);
        const Pixel peak{x_(100 * run.curve.axial_strain[run.curve.peak]), y_(1e-6 * run.curve.peak_stress())};
        drawing_.polyline({peak, peak}, 14, colour);
    }

    void title(const std::string& first, const std::string& second) {
        drawing_.text({{left_margin, 50}, first, 34, palette::ink, Anchor::start, true});
        drawing_.text({{left_margin, 90}, second, label_size});
    }

    /// An entry of the legend in a line and, where entries share one, a column of `column_width` pixels.
    void legend(std::size_t line, std::size_t column, Colour colour, double width, const std::string& words) {
        constexpr double column_width = 300;
        const double x = left_margin + column_width * static_cast<double>(column);
        const double y = y_.from + bottom_margin - 2 + legend_line * static_cast<double>(line);
        drawing_.line({x, y - 8}, {x + 50, y - 8}, width, colour);
        drawing_.text({{x + 66, y}, words, tick_size});
    }

private:
    static std::string tick_text(double tick) { return format_number(std::abs(tick) < 1e-12 ? 0.0 : tick, 6); }

    /// A polyline through (x, y); what leaves the frame interrupts it.
    void draw_line(const std::vector<double>& x, double x_factor, const std::vector<double>& y, double y_factor,
                   const Scale& y_scale, double width, Colour colour) {
        std::vector<Pixel> points;
        const auto finish = [&] {
            if (points.size() > 1) drawing_.polyline(points, width, colour);
            points.clear();
        };
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double u = x_factor * x[i];
            const double v = y_factor * y[i];
            if (x_.holds(u) && y_scale.holds(v)) {
                points.push_back({x_(u), y_scale(v)});
            } else {
                finish();
            }
        }
        finish();
    }

    Drawing drawing_;
    Scale x_;
    Scale y_;
};

std::string legend_words(const Run& run) {
    const std::string name = std::filesystem::path(run.data->name).filename().string();
    std::string words = fmt::format("{}: peak {:.4g} MPa", name, 1e-6 * run.curve.peak_stress());
    if (run.data->header.test == "triaxial") words += fmt::format(" at {:.4g} MPa", 1e-6 * run.data->header.confining_pressure);
    return words + fmt::format(", seed {}", run.data->specimen.seed);
}

}  // namespace

Drawing draw_curves(const std::vector<RunData>& data) {
    const std::vector<Run> runs = prepare(data);
    const bool single = runs.size() == 1;
    CurvePage page(runs, single ? 1 : runs.size());
    const RunHeader& header = data.front().header;
    page.draw_axes(header.test == "brazilian" ? "2F/(πtD), MPa" : "axial stress, MPa");
    if (single) {
        const RunData& run = data.front();
        page.title(test_title(header),
                   fmt::format("seed {}, {} grains, mean edge {:.3g} mm; peak {:.4g} MPa at {:.3g} % strain", run.specimen.seed,
                               run.specimen.grains, run.specimen.mean_edge * 1e3, 1e-6 * runs[0].curve.peak_stress(),
                               100 * runs[0].curve.axial_strain[runs[0].curve.peak]));
        page.draw_cracks(runs[0]);
        page.legend(0, 0, palette::series(0), 4, "stress");
        page.legend(0, 1, palette::tensile, 2.4, "tensile cracks");
        page.legend(0, 2, palette::shear, 2.4, "shear cracks");
    } else {
        page.title(header.material.empty() ? "Stress and strain" : header.material, fmt::format("{} runs", runs.size()));
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
        page.draw_run(runs[i], palette::series(i));
        if (!single) page.legend(i, 0, palette::series(i), 4, legend_words(runs[i]));
    }
    page.draw_frame();
    return page.drawing();
}

}  // namespace graincrack
