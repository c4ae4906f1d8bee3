#include "post/film/film_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "post/measure/caveats.hpp"
#include "post/run/contact_classes.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/crystals.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

// In pixels of the drawing.
constexpr double page_height = 1000;
constexpr double above_page = 14;
constexpr double beside_map = 66;  ///< of a map's height: what stands above and below it on its own page
constexpr double scale_bar = 46;   ///< below the map
constexpr double lowest_chart = 80;
constexpr double largest_map = 0.5;  ///< of the width of the page

/// The last of ascending values that is not above a value; the first if all are.
std::size_t last_until(const std::vector<double>& ascending, double value) {
    const auto next = std::upper_bound(ascending.begin(), ascending.end(), value);
    return next == ascending.begin() ? 0 : static_cast<std::size_t>(next - ascending.begin()) - 1;
}

std::vector<double> until(const std::vector<double>& values, std::size_t row) {
    return {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(row) + 1};
}

RunData data_of(const RunReader& run, const FilmContents& contents, const std::vector<Crack>& cracks) {
    RunData data = run_data(run, contents.label);
    count_in_history(cracks, data.history);
    return data;
}

std::vector<Crack> cracks_of_film(const RunReader& run, const Specimen& specimen, const FilmContents& contents) {
    const std::vector<bool> contacts = contacts_of_classes(specimen, contents.classes, run.name());
    return cracks_of(read_labelled_cracks(run, specimen, contents.label), contacts);
}

/// How far a quantity has travelled in each row, both ways counted.
std::vector<double> way_of(const std::vector<double>& values, std::size_t first, std::size_t last) {
    std::vector<double> way{0};
    for (std::size_t row = first + 1; row <= last; ++row) way.push_back(way.back() + std::abs(values[row] - values[row - 1]));
    return way;
}

std::vector<double> checked_frame_times(const RunReader& run) {
    std::vector<double> times = run.frame_times();
    if (times.empty() || !(times.back() > times.front())) {
        throw InputError(fmt::format("{}: has {}; a film needs two at least, run the solver with --frames 2 or more", run.name(),
                                     times.empty() ? "no frames" : "frames of one time only"));
    }
    return times;
}

}  // namespace

std::vector<std::size_t> film_rows(const std::vector<double>& values, std::size_t first, std::size_t last, std::size_t count) {
    const std::vector<double> travelled = way_of(values, first, last);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        constexpr double round_off = 1 + 1e-9;
        rows.push_back(first + last_until(travelled, round_off * part * travelled.back()));
    }
    rows.push_back(last);
    return rows;
}

std::vector<double> film_way(FilmSteps steps, const History& history) {
    if (steps == FilmSteps::time) return history[HistoryColumn::time];
    constexpr double share_of_strain = 0.25;
    const auto &tensile = history[HistoryColumn::tensile_cracks], &shear = history[HistoryColumn::shear_cracks];
    std::vector<double> way = way_of(history[HistoryColumn::axial_strain], 0, history.size() - 1);
    const double cracks = tensile.back() + shear.back(), strain = way.back();
    if (steps == FilmSteps::strain || !(cracks > 0) || !(strain > 0)) return way;
    for (std::size_t row = 0; row < way.size(); ++row) {
        way[row] = share_of_strain * way[row] / strain + (1 - share_of_strain) * (tensile[row] + shear[row]) / cracks;
    }
    return way;
}

FilmPage::FilmPage(const RunReader& run, FilmContents contents)
    : run_(run),
      contents_(std::move(contents)),
      specimen_(run.specimen()),
      cracks_(cracks_of_film(run, specimen_, contents_)),
      data_(data_of(run, contents_, cracks_)),
      curve_(load_curve(data_)),
      way_(film_way(contents_.steps, data_.history)),
      frame_times_(checked_frame_times(run)),
      page_width_(std::round(page_height * contents_.size.width / contents_.size.height)) {
    const std::size_t first = row_at(frame_times_.front()), last = row_at(frame_times_.back());
    if (!(way_of(way_, first, last).back() > 0)) {
        throw InputError(run.name() + ": its strain does not change from the first frame to the last; --by time shows it");
    }
    notes_ = crack_notes(specimen_, contents_.label.of(data_.header), contents_.classes);
    for (const Caveat& caveat : caveats_of(run, data_)) notes_.push_back(note_line(caveat));
    if (has_platens_to_draw(data_)) platens_ = read_platen_faces(run.file(), specimen_);
    for (std::size_t frame = 0; frame < frame_times_.size(); ++frame) {
        throw_if_interrupted();
        view_.include(view_box(specimen_, nodes_in(frame)));
    }
    const double shape = (view_.high[0] - view_.low[0]) / (view_.high[1] - view_.low[1]);
    const double widest = largest_map * page_width_ - 2 * page_margin;
    map_width_ = std::floor(std::min(shape * (page_height - beside_map - scale_bar), widest) + 2 * page_margin);
}

std::size_t FilmPage::row_at(double time) const { return last_until(times(), time); }

Positions FilmPage::nodes_in(std::size_t frame) const {
    return moved_nodes(specimen_, read_frame(run_, specimen_, frame), contents_.magnification);
}

std::vector<std::size_t> FilmPage::rows(std::size_t count) const {
    return film_rows(way_, row_at(frame_times_.front()), row_at(frame_times_.back()), count);
}

TextColumn FilmPage::column() const { return {map_width_ + page_margin, page_width_ - page_margin}; }

/// The map with a scale bar, in the middle of the height of the page.
Drawing FilmPage::map_at(double time, const std::vector<Crack>& present) const {
    const std::size_t frame = last_until(frame_times_, time);
    MapPage form{PictureStyle{}.of_part(map_width_), page_height - beside_map - scale_bar, page_margin, 0, view_};
    MapView map(specimen_, nodes_in(frame), {}, form);
    std::optional<PlatensAtStrain> platens;
    if (platens_) {
        const double strain = data_.history[HistoryColumn::axial_strain][row_at(frame_times_[frame])];
        platens = {*platens_, contents_.magnification * strain};
    }
    draw_crack_state(map, specimen_, platens, present);
    const MapScale scale = map.scale();
    const Drawing drawn = std::move(map).drawing();
    Drawing part(static_cast<int>(map_width_), static_cast<int>(page_height));
    const double top = std::max(0.0, (page_height - drawn.height() - scale_bar) / 2);
    part.add(drawn, {0, top});
    const double end = top + drawn.height();
    draw_scale_bar(part, scale, {page_margin, map_width_ - page_margin}, {{page_margin, end}, end});
    return part;
}

/// The legend of colours and lines, and the caveats of the test. \return the height at which it ends
double FilmPage::draw_foot(Drawing& page, double top) const {
    std::vector<LegendEntry> legend;
    if (has_pre_existing_cracks(specimen_)) legend.push_back({Stroke{palette::pre_existing, 6}, "pre-existing"});
    for (LegendEntry& phase : phase_legend(specimen_)) legend.push_back(std::move(phase));
    const double below = legend.empty() ? top : draw_legend(page, legend, column(), top).bottom;
    return draw_heading(page, {"", notes_}, column(), below);
}

/// The whole curve pale, as far as the test has come dark, and a point where it is.
Drawing FilmPage::stress_chart(std::size_t row, double height) const {
    const std::vector<double> strain = graincrack::times(curve_.axial_strain, 100);
    const std::vector<double> stress = graincrack::times(curve_.stress, 1e-6);
    Chart chart(PictureStyle{}.of_part(page_width_ - map_width_), {},
                Axis{"axial strain, %", std::min(0.0, smallest(strain)), 1.03 * largest(strain)},
                Axis{stress_name(data_) + ", MPa", std::min(0.0, smallest(stress)), 1.1 * largest(stress)}, {.height = height});
    chart.line(strain, stress, Stroke{palette::outline, 3});
    chart.line(until(strain, row), until(stress, row), series_stroke(0, 4.5));
    chart.points(std::vector{strain[row]}, std::vector{stress[row]}, Marker{palette::series(0), MarkerShape::disc, 22});
    return chart.finish();
}

Drawing FilmPage::at(std::size_t row) const {
    const double time = times()[row];
    const std::vector<Crack> present = cracks_until(cracks_, time);
    Drawing page(static_cast<int>(page_width_), static_cast<int>(page_height));
    page.add(map_at(time, present), {0, 0});
    std::vector<std::string> facts{
        fmt::format("seed {}, {}, plane {}", specimen_.seed, grains_label(specimen_), name_of(data_.header.plane))};
    if (contents_.magnification != 1) facts.back() += fmt::format("; displacements × {:.3g}", contents_.magnification);
    const std::string stress = stress_name(data_);
    facts.push_back(fmt::format("strain {} %, {} {} MPa, time {} ms", fixed_digits(100 * curve_.axial_strain[row], 3),
                                stress == "axial stress" ? "stress" : stress, fixed_digits(1e-6 * curve_.stress[row], 1),
                                fixed_digits(1e3 * time, 2)));
    const std::string title = contents_.title.empty() ? test_title(data_.header) : contents_.title;
    double below = draw_heading(page, {title, facts}, column(), above_page) + 8;
    for (const LegendEntry& count :
         {LegendEntry{Stroke{palette::tensile, 6}, "tensile cracks: " + cracked_contacts(present, CrackMode::tensile)},
          LegendEntry{Stroke{palette::shear, 6}, "shear cracks: " + cracked_contacts(present, CrackMode::shear)}}) {
        below = draw_legend(page, {count}, column(), below).bottom;
    }
    Drawing scratch(static_cast<int>(page_width_), 0);
    const double foot = page_height - above_page - draw_foot(scratch, 0);
    draw_foot(page, foot);
    const double room = foot - below - (stress_chart(row, lowest_chart).height() - lowest_chart);
    page.add(stress_chart(row, std::max(lowest_chart, std::floor(room))), {map_width_, below});
    return page;
}

}  // namespace graincrack
