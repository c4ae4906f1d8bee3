#include "post/report/view_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <set>

#include "post/chart/axis.hpp"
#include "post/chart/map_view.hpp"
#include "post/measure/caveats.hpp"
#include "post/measure/thresholds.hpp"
#include "post/report/html.hpp"
#include "post/report/packed_array.hpp"
#include "post/run/contact_classes.hpp"
#include "post/run/crystals.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/file/platen_faces.hpp"

namespace graincrack {

namespace {

using Json = nlohmann::ordered_json;

// The files beside this one, as they stand there.
const char* const skeleton =
#include "view.html.inc"
    ;
const char* const style_sheet =
#include "view.css.inc"
    ;
const char* const script =
#include "view.js.inc"
    ;
const char* const map_script =
#include "map.js.inc"
    ;

Json array_of(const std::vector<double>& values) {
    const QuantisedArray array = quantised(values);
    return {{"low", array.low}, {"step", array.step}, {"data", packed(array.steps)}};
}

/// Whole numbers. \param get of an index
template <class Get>
Json whole_array(std::size_t n, const Get& get) {
    std::vector<std::int32_t> values(n);
    for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<std::int32_t>(get(i));
    return {{"data", packed(values)}};
}

/// Components of an array of several, one after the other.
template <std::size_t N>
std::vector<double> components(const std::vector<std::array<double, N>>& values, std::initializer_list<std::size_t> which) {
    std::vector<double> columns;
    for (const std::size_t k : which) {
        for (const auto& each : values) columns.push_back(each[k]);
    }
    return columns;
}

std::string css(Colour colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue); }

Json named(const std::string& name, Colour colour) { return {{"name", printable(mineral_label(name))}, {"colour", css(colour)}}; }

/// Crack initiation and damage of a compression test, and the peak.
Json marks_of(const RunData& run, const LoadCurve& curve) {
    Json marks = Json::array();
    const auto mark = [&](const char* symbol, const std::string& name, const std::optional<double>& stress) {
        if (!stress) return;
        const std::string text = fmt::format("{} {:.1f} MPa, {:.2f} of the {}", name, 1e-6 * *stress,
                                             *stress / curve.peak_stress(), curve.peak_name());
        marks.push_back({{"symbol", symbol}, {"text", text}, {"y", 1e-6 * *stress}});
    };
    if (is_compression(run.header)) {
        const AllThresholds thresholds = measure_all_thresholds(run, curve, {});
        mark("CI", "crack initiation CI", thresholds.initiation());
        mark("CD", "crack damage CD", thresholds.damage());
    }
    marks.push_back({{"symbol", curve.peak_name()},
                     {"text", fmt::format("{} {:.1f} MPa", curve.peak_name(), 1e-6 * curve.peak_stress())},
                     {"x", 100 * curve.axial_strain[curve.peak]},
                     {"y", 1e-6 * curve.peak_stress()}});
    return marks;
}

/// What a page holds of one run, as it is gathered.
class RunPart {
public:
    RunPart(const RunReader& run, const ViewOptions& options)
        : run_(run),
          specimen_(run.specimen()),
          label_(options.label.of(run.header())),
          cracks_(read_labelled_cracks(run, specimen_, options.label)),
          data_(run_data(run, options.label)),
          curve_(load_curve_if_any(data_)),
          course_(load_course(run, data_)) {
        if (data_.history.size() == 0) throw InputError(run.name() + ": has no history; a run that has begun is needed");
        std::stable_sort(cracks_.begin(), cracks_.end(), [](const Crack& a, const Crack& b) { return a.time < b.time; });
        frames_ = evenly_chosen(run.n_frames(), static_cast<std::size_t>(options.frames),
                                choose_frame(run, curve_ ? "peak" : "last", std::nullopt));
    }

    [[nodiscard]] Json part() {
        Json part{{"file", printable(run_.name())}, {"title", printable(test_title(data_.header))}};
        part["facts"] =
            fmt::format("seed {}, {}, plane {}", specimen_.seed, grains_label(specimen_), name_of(data_.header.plane));
        part["notes"] = crack_notes(specimen_, label_);
        for (const Caveat& caveat : caveats_of(run_, data_)) part["notes"].push_back(note_line(caveat));
        part["specimen"] = specimen_part();
        part["platens"] = platens();
        part["cracks"] = cracks();
        part["curve"] = {{"across", printable(course_.across + ", " + course_.across_unit)},
                         {"up", course_.up + ", " + course_.up_unit},
                         {"unit", course_.up_unit},
                         {"x", array_of(course_.x)},
                         {"y", array_of(course_.y)},
                         {"marks", curve_ ? marks_of(data_, *curve_) : Json::array()}};
        part["frames"] = Json::array();
        for (const std::size_t index : frames_) part["frames"].push_back(frame(index));
        part["limits"] = {limit(most_), limit(least_)};
        return part;
    }

private:
    /// Nodes, elements, contacts and the boundary at rest; the nodes of contacts and edges in columns.
    [[nodiscard]] Json specimen_part() const {
        const Specimen& s = specimen_;
        const ContactClasses classes = classes_of(s);
        const std::size_t n = s.n_contacts(), edges = s.n_boundary_edges();
        Json part{{"width", s.width}, {"height", s.height}, {"edge", s.statistics.mean_edge}};
        part["phases"] = Json::array();
        const std::vector<Colour> colours = palette::phases(s.phase_names);
        for (std::size_t i = 0; i < colours.size(); ++i) part["phases"].push_back(named(s.phase_names[i], colours[i]));
        part["classes"] = classes_part(classes);
        part["x"] = array_of(components(s.node_position, {0}));
        part["y"] = array_of(components(s.node_position, {1}));
        part["elements"] = whole_array(3 * s.n_elements(), [&](auto i) { return s.element_nodes[i / 3][i % 3]; });
        part["phase"] =
            whole_array(s.n_elements(), [&](auto e) { return s.grain_phase[static_cast<std::size_t>(s.element_grain[e])]; });
        part["contacts"] = whole_array(4 * n, [&](auto i) { return s.contact_nodes[i % n][i / n]; });
        part["class"] = whole_array(n, [&](auto c) { return classes.of_contact[c]; });
        part["within"] = whole_array(n, [&](auto c) { return is_within_crystal(s, c); });
        part["broken"] = whole_array(n, [&](auto c) { return starts_broken(s.contact_kind[c]); });
        part["boundary"] = whole_array(2 * edges, [&](auto i) { return s.boundary_edges[i % edges][i / edges]; });
        return part;
    }
    /// The six classes with the most cracks have colours of their own, all others one in common.
    [[nodiscard]] Json classes_part(const ContactClasses& classes) const {
        constexpr std::size_t own_colours = 6;
        std::vector<std::size_t> points(classes.names.size()), rank(points.size());
        for (const Crack& crack : cracks_) ++points[classes.of_contact[static_cast<std::size_t>(crack.contact)]];
        std::iota(rank.begin(), rank.end(), 0);
        std::stable_sort(rank.begin(), rank.end(), [&](std::size_t a, std::size_t b) { return points[a] > points[b]; });
        Json part(points.size(), nullptr);
        for (std::size_t i = 0; i < rank.size(); ++i) {
            Json& each = part[rank[i]] = named(classes.names[rank[i]], palette::series(std::min(i, own_colours)));
            each["group"] = i < own_colours ? each["name"] : "other pairs";
        }
        return part;
    }
    /// The bar of each platen, a thirtieth of the height thick: corners, and the way of these where it approaches by 1 m.
    [[nodiscard]] Json platens() const {
        Json bars = Json::array();
        if (!has_platens_to_draw(data_)) return bars;
        const PlatenFaceSet set = read_platen_faces(run_.file(), specimen_);
        for (const PlatenFace& face : set.faces) {
            bars.push_back({{"corners", set.bar(face, specimen_.height / 30, 0)}, {"way", set.displacement(face, 1)}});
        }
        return bars;
    }
    /// In the order of their times, so that each frame shows the first ones.
    [[nodiscard]] Json cracks() const {
        const std::size_t n = cracks_.size();
        std::vector<double> load;
        for (const Crack& crack : cracks_) load.push_back(course_.y[row_at(data_.history, crack.time)]);
        return {{"contact", whole_array(n, [&](auto i) { return cracks_[i].contact; })},
                {"point", whole_array(n, [&](auto i) { return cracks_[i].point; })},
                {"shear", whole_array(n, [&](auto i) { return cracks_[i].mode == CrackMode::shear; })},
                {"load", array_of(load)}};
    }
    [[nodiscard]] Json frame(std::size_t index) {
        throw_if_interrupted();
        const Frame frame = read_whole_frame(run_, specimen_, index);
        const std::vector<Crack> present = cracks_until(cracks_, frame.time);
        const std::size_t row = row_at(data_.history, frame.time);
        for (const auto& [xx, yy, xy, zz] : frame.element_stress) {
            const double radius = std::hypot((xx - yy) / 2, xy);
            if (!std::isfinite(xx + yy + radius)) continue;
            most_.push_back(std::abs((xx + yy) / 2 + radius));
            least_.push_back(std::abs((xx + yy) / 2 - radius));
        }
        const auto stress = [&](std::size_t k) { return array_of(times(components(frame.element_stress, {k}), 1e-6)); };
        return {
            {"index", index},
            {"x", course_.x[row]},
            {"y", course_.y[row]},
            {"text", printable(fmt::format("{} {} {}, {} {} {}", course_.across, fixed_digits(course_.x[row], 3),
                                           course_.across_unit, course_.up, fixed_digits(course_.y[row], 1), course_.up_unit))},
            {"cracks", present.size()},
            {"counts", {cracked_contacts(present, CrackMode::tensile), cracked_contacts(present, CrackMode::shear)}},
            {"approach", -data_.history[HistoryColumn::axial_strain][row] * specimen_.height / 2},
            {"u", array_of(components(frame.displacement, {0}))},
            {"v", array_of(components(frame.displacement, {1}))},
            {"xx", stress(0)},
            {"yy", stress(1)},
            {"xy", stress(2)},
            {"opening", array_of(times(components(frame.opening, {0, 1}), 1e6))},
            {"sliding", array_of(times(components(frame.sliding, {0, 1}), 1e6))}};
    }
    /// The magnitude of stress that only the hundredth part of elements and frames exceeds, MPa.
    static double limit(std::vector<double>& magnitudes) {
        if (magnitudes.empty()) return 1;
        const auto place = magnitudes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(magnitudes.size()));
        std::nth_element(magnitudes.begin(), place, magnitudes.end());
        return std::max(1e-6 * *place, 1e-6);
    }

    const RunReader& run_;
    Specimen specimen_;
    CrackLabel label_;
    std::vector<Crack> cracks_;
    RunData data_;
    std::optional<LoadCurve> curve_;
    LoadCourse course_;
    std::vector<std::size_t> frames_;
    std::vector<double> most_, least_;  ///< magnitudes of principal stresses, Pa
};

/// As text of a page, in which no tag begins.
std::string page_text(const Json& json) {
    std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) text.replace(at, 1, "\\u003c");
    return text;
}

}  // namespace

std::vector<std::size_t> evenly_chosen(std::size_t n, std::size_t most, std::size_t kept) {
    std::set<std::size_t> chosen{kept, n - 1};
    const std::size_t even = n <= most ? n : most - 1;
    for (std::size_t i = 0; i + 1 < even; ++i) chosen.insert(i * (n - 1) / (even - 1));
    return {chosen.begin(), chosen.end()};
}

ViewedRun viewed_run(const RunReader& run, const ViewOptions& options) {
    const Json part = RunPart(run, options).part();
    return {page_text(part), part["frames"].size()};
}

std::string map_scripts(const std::vector<ViewedRun>& runs) {
    Json colours{{"series", {css(palette::series(0)), css(palette::series(1))}},
                 {"directions", {css({0, 90, 150}), css(palette::series(1))}}};
    for (const auto& [name, colour] : {std::pair{"tensile", palette::tensile},
                                       {"shear", palette::shear},
                                       {"platen", palette::platen},
                                       {"open", palette::pre_existing},
                                       {"outline", palette::outline},
                                       {"rim", palette::rim}}) {
        colours[name] = css(colour);
    }
    std::vector<std::string> parts;
    for (const ViewedRun& run : runs) parts.push_back(run.json);
    constexpr const char* data = "<script type=\"application/json\" id=\"{}\">{}</script>\n";
    return fmt::format(fmt::runtime(data), "colours", page_text(colours)) +
           fmt::format(fmt::runtime(data), "runs", fmt::format("[{}]", fmt::join(parts, ","))) + "<script>" + map_script +
           "</script>\n";
}

std::string make_view(const std::vector<std::string>& runs, const ViewOptions& options, Verbosity verbosity) {
    std::vector<ViewedRun> all;
    std::string title;
    Progress progress("view", verbosity);
    for (const std::string& path : runs) {
        throw_if_interrupted();
        const RunReader run(path);
        if (all.empty()) title = printable(test_title(run.header())) + (runs.size() > 1 ? " and others" : "");
        all.push_back(viewed_run(run, options));
        progress.update(static_cast<double>(all.size()) / static_cast<double>(runs.size()), run.name());
    }
    progress.finish();
    return fmt::format(fmt::runtime(skeleton), fmt::arg("title", escape_xml(title)), fmt::arg("style", style_sheet),
                       fmt::arg("maps", map_scripts(all)), fmt::arg("script", script));
}

}  // namespace graincrack
