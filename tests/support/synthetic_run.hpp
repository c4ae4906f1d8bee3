// Runs with known answers, made without a solver: a grid of triangular grains and a history of straight lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "share/file/h5_file.hpp"
#include "share/file/provenance.hpp"
#include "share/file/run_file.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {

/// columns × rows rectangles, each cut along its rising diagonal into two grains of one triangle. Contacts are in the order of
/// the grains that complete them, boundary edges in that of the places where they begin.
inline Specimen grid_specimen(int columns, int rows, double width, double height) {
    Specimen s = one_diagonal_grid(columns, rows, width, height);
    s.tessellation = "grid";
    s.seed = 7;
    s.grain_area.assign(s.n_grains(), width * height / (2.0 * columns * rows));
    std::ranges::sort(s.contact_nodes, {}, [](const auto& nodes) { return nodes[3]; });
    std::ranges::sort(s.boundary_edges, {}, [&s](const auto& nodes) { return s.node_position[nodes[0]]; });
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        const auto& [x, y] = s.node_position[s.boundary_edges[e][0]];
        const bool level = y == s.node_position[s.boundary_edges[e][1]][1];
        s.boundary_part[e] = level ? (y < 0 ? 0 : 2) : (x < 0 ? 3 : 1);
    }
    const double dx = width / columns;
    const double dy = height / rows;
    const double level = columns * (rows + 1.0);
    const double upright = rows * (columns + 1.0);
    const double inclined = double(columns) * rows;
    s.statistics.mean_edge = (level * dx + upright * dy + inclined * std::hypot(dx, dy)) / (level + upright + inclined);
    return s;
}

/// What a synthetic run is made of. Slopes are those of the plane: stress over gauge strain.
struct Recipe {
    std::string test = "uniaxial";
    PlaneCondition plane = PlaneCondition::strain;
    double plane_young_modulus = 26e9;  ///< Pa
    double plane_poisson_ratio = 0.3;
    double platen_compliance = 1.02;  ///< platen strain over gauge strain
    double confining_pressure = 0;    ///< Pa
    double peak = 125e6;              ///< axial stress (brazilian: 2 F/(π D)), positive, Pa
    double drop = 0.5;                ///< share of the peak lost at the end; 0: the curve ends at the peak
    double hardens_to = 0;            ///< behind that fall the stress rises to this until 2.25 s, Pa; 0: the curve ends there
    std::string stop_reason = "peak drop";
    double yield_share = 2;  ///< from this share of the peak on the tangent is halved; > 1: never
    Specimen specimen = grid_specimen(8, 16, 0.08, 0.16);
    int rows = 101;
    CrackEvent crack_event = CrackEvent::failed;
    double platen_speed = 0.005;  ///< m/s
    double span = 0;              ///< of a test in bending, m
    std::string material = "Augig granite";
};

/// Elastic loading in equal steps of stress up to the peak at time 1 s, then a straight fall until 1.25 s. A triaxial
/// test begins with an isotropic stage of ten rows up to 0 s, whose strains are not those of axial loading.
inline History synthetic_history(const Recipe& r) {
    using enum HistoryColumn;
    History h;
    const double sense = r.test == "tension" ? 1 : -1;
    const bool triaxial = r.confining_pressure > 0;
    const auto add = [&](double time, double stress, double strain) {
        const double lateral = -sense * r.plane_poisson_ratio * std::abs(strain);
        for (auto& column : h.columns) column.push_back(0);
        const auto set = [&](HistoryColumn c, double v) { h[c].back() = v; };
        set(HistoryColumn::time, time);
        set(step, std::round(1000 * (time + 1)));
        set(gauge_axial_strain, sense * strain);
        set(gauge_lateral_strain, lateral);
        set(axial_strain, sense * strain * r.platen_compliance);
        set(lateral_strain, 1.1 * lateral);
        const double force =
            r.test == "brazilian" ? stress * 3.14159265358979323846 * r.specimen.width / 2 : stress * r.specimen.width;
        set(axial_stress, sense * force / r.specimen.width);
        set(force_top, sense * force * 1.001);
        set(force_bottom, sense * force * 0.999);
        set(tensile_cracks, time <= 0.5 ? 0 : std::floor(40 * (time - 0.5)));
        set(shear_cracks, time <= 0.75 ? 0 : std::floor(20 * (time - 0.75)));
    };
    double strain0 = 0;
    if (triaxial) {
        for (int i = 0; i < 10; ++i) add(-1 + i * 0.1, r.confining_pressure * i / 10.0, 1e-4 * i / 10.0);
        strain0 = 1e-4;
    }
    const double from = r.confining_pressure;
    double strain = strain0;
    double before = from;
    for (int i = 0; i < r.rows; ++i) {
        const double share = i / (r.rows - 1.0);
        const double stress = from + share * (r.peak - from);
        const double stiffness = r.plane_young_modulus * (share > r.yield_share ? 0.5 : 1.0);
        strain += (stress - before) / stiffness;
        before = stress;
        add(share, stress, strain);
    }
    const double peak_strain = strain;
    for (int i = 1; i <= 10 && r.drop > 0; ++i) {
        add(1 + 0.025 * i, r.peak * (1 - r.drop * i / 10.0), peak_strain * (1 + 0.02 * i));
    }
    for (int i = 1; i <= 100 && r.hardens_to > 0; ++i) {
        const double low = r.peak * (1 - r.drop);
        add(1.25 + 0.01 * i, low + (r.hardens_to - low) * i / 100.0, peak_strain * (1.2 + 0.02 * i));
    }
    if (triaxial) {
        for (double& t : h[HistoryColumn::time]) t += 1;  // time starts at 0
    }
    return h;
}

/// Adds to the lateral strain, elongation positive, from half the peak on: `extra` times the square of the stress beyond, MPa².
/// After the peak all of it stays.
inline void widen(History& history, const Recipe& r, double extra) {
    double widest = 0;
    for (std::size_t row = 0; row < history.size(); ++row) {
        const double beyond = std::max(std::abs(history[HistoryColumn::axial_stress][row]) - 0.5 * r.peak, 0.0) * 1e-6;
        widest = std::max(widest, extra * beyond * beyond);
        history[HistoryColumn::gauge_lateral_strain][row] += widest;
    }
}

inline RunHeader synthetic_header(const Recipe& r) {
    RunHeader header;
    header.test = r.test;
    header.material = r.material;
    header.contact_law = "literal";
    header.crack_event = r.crack_event;
    header.fracture_energy_choice = "mode-i";
    header.plane = r.plane;
    header.rock = {25.8e9, 0.23, 2650, 1.5e6, 3.0e6, 8.8e6};
    header.contact = contact_parameters(read_material("augig-granite"), r.plane, std::nullopt);
    header.confining_pressure = r.confining_pressure;
    header.platen_speed = r.platen_speed;
    header.span = r.span;
    header.peak_drop = 0.3;
    header.max_strain = 0.015;
    header.time_step = 5e-8;
    header.stop_reason = r.stop_reason;
    header.steps = 200000;
    header.integrations = header.steps;
    header.isotropic_end_time = r.confining_pressure > 0 ? 1.0 : 0.0;
    header.energy_balance_error = 0.002;
    header.platen_force_difference = 0.01;
    return header;
}

/// Uniform compression by `strain` with a ratio of 0.3, and a band of grains above the diagonal pushed aside.
inline Frame synthetic_frame(const Specimen& s, double time, double strain, double slip) {
    Frame f;
    f.time = time;
    f.step = static_cast<std::int64_t>(1000 * time);
    f.displacement.resize(s.n_nodes());
    f.velocity.assign(s.n_nodes(), {0.001, -0.005});
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    for (std::size_t i = 0; i < s.n_nodes(); ++i) {
        const auto& [x, y] = s.node_position[i];
        const auto& element = s.element_nodes[static_cast<std::size_t>(grain[i])];
        double middle = 0;
        for (std::int32_t node : element) middle += (s.node_position[node][1] - s.node_position[node][0]) / 3;
        const double push = middle > 0 ? slip : 0;
        f.displacement[i] = {0.3 * strain * x - push, -strain * y + 0.5 * push};
    }
    f.element_stress.assign(s.n_elements(), {1e6, -100e6, 5e6, -20e6});
    f.opening.assign(s.n_contacts(), {1e-6, 2e-6});
    f.sliding.assign(s.n_contacts(), {0, 0});
    f.traction.assign(s.n_contacts(), {0, 0, 0, 0});
    f.damage.assign(s.n_contacts(), {0, 0});
    f.state.assign(s.n_contacts(), {0, 0});
    return f;
}

/// Both points of the contacts across the line y = x: upright facets tensile, inclined ones shear, others tensile; at even
/// times between 0.5 s and 1.2 s. Every second one separates at once.
inline std::vector<Crack> synthetic_cracks(const Specimen& s) {
    std::vector<Crack> cracks;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto& a = s.node_position[static_cast<std::size_t>(s.contact_nodes[c][0])];
        const auto& b = s.node_position[static_cast<std::size_t>(s.contact_nodes[c][1])];
        if (std::abs((a[0] + b[0]) / 2 - (a[1] + b[1]) / 2) > 0.01) continue;
        const double angle = std::atan2(b[1] - a[1], b[0] - a[0]);
        for (std::uint8_t point = 0; point < 2; ++point) {
            const double share = point == 0 ? 0.25 : 0.75;
            Crack crack;
            crack.contact = static_cast<std::int32_t>(c);
            crack.point = point;
            crack.orientation = angle < 0 ? angle + 3.14159265358979323846 : angle;
            if (crack.orientation >= 3.14159265358979323846) crack.orientation = 0;
            const bool inclined = std::abs(std::sin(2 * angle)) > 0.5;
            crack.mode = inclined ? CrackMode::shear : CrackMode::tensile;
            crack.mode_angle = inclined ? 2.5 : 0.2;
            crack.position = {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
            crack.length = std::hypot(b[0] - a[0], b[1] - a[1]) / 2;
            crack.opening = 2e-6;
            crack.sliding = 1e-6;
            crack.energy_released = 0.1;
            cracks.push_back(crack);
        }
    }
    for (std::size_t i = 0; i < cracks.size(); ++i) {
        cracks[i].time = 0.5 + 0.7 * static_cast<double>(i) / static_cast<double>(cracks.size());
        cracks[i].step = static_cast<std::int64_t>(1000 * cracks[i].time);
        if (i % 2 == 0) cracks[i].separated.time = cracks[i].time;
    }
    return cracks;
}

/// Writes a run with frames at 0, 1 (peak) and 1.25 s.
inline void write_run(const std::string& path, const Recipe& recipe, const std::vector<Crack>& cracks) {
    RunWriter writer(H5Output(path, "run"), recipe.specimen, synthetic_header(recipe));
    writer.append_history(synthetic_history(recipe));
    writer.add_frame(synthetic_frame(recipe.specimen, 0, 0, 0), FrameRole::regular);
    writer.add_frame(synthetic_frame(recipe.specimen, 1, 0.005, 0), FrameRole::kept);
    writer.add_frame(synthetic_frame(recipe.specimen, 1.25, 0.006, 0.001), FrameRole::kept);
    if (recipe.hardens_to > 0) writer.add_frame(synthetic_frame(recipe.specimen, 2.25, 0.015, 0.001), FrameRole::kept);
    writer.finish(synthetic_header(recipe), cracks,
                  {.tool = "synthetic", .command_line = {"synthetic"}, .libraries = {"none"}, .wall_time = 12.8});
}
inline void write_run(const std::string& path, const Recipe& recipe) {
    write_run(path, recipe, synthetic_cracks(recipe.specimen));
}

/// A TSV as rows of fields, the header first.
inline std::vector<std::vector<std::string>> parse_tsv(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        rows.emplace_back();
        std::size_t from = 0;
        for (std::size_t tab = line.find('\t'); tab != std::string::npos; tab = line.find('\t', from)) {
            rows.back().push_back(line.substr(from, tab - from));
            from = tab + 1;
        }
        rows.back().push_back(line.substr(from));
    }
    return rows;
}

/// Field of a named column in a data row (0 is the first below the header); "(no such column)" if there is none.
inline std::string field(const std::string& tsv, const std::string& column, std::size_t row = 0) {
    const auto rows = parse_tsv(tsv);
    for (std::size_t c = 0; c < rows.at(0).size(); ++c) {
        if (rows[0][c] == column) return rows.at(row + 1).at(c);
    }
    return "(no such column)";
}

/// A table for terminals with two blanks between columns, whatever the lengths of the names of files.
inline std::string narrow(const std::string& table) { return std::regex_replace(table, std::regex("  +"), "  "); }

inline std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace graincrack::test
