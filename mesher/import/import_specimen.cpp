#include "mesher/import/import_specimen.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>

#include "mesher/fabric/crystals.hpp"
#include "mesher/import/label_table.hpp"
#include "share/base/error.hpp"
#include "share/base/sha256.hpp"
#include "share/base/units.hpp"
#include "share/file/open_boundaries.hpp"
#include "share/file/output_file.hpp"

namespace graincrack::mesher {

namespace {

constexpr double preferred = 0.15;  ///< psi6 from which a mesh counts as one with a preferred direction, as of meshes made here

std::string mm(double length) { return fmt::format("{:.4g} mm", in_unit(length, Dimension::length, "mm")); }

/// Parts of the boundary with their lengths.
std::string parts_line(const Specimen& specimen) {
    std::vector<double> lengths(specimen.part_names.size(), 0);
    for (std::size_t b = 0; b < specimen.n_boundary_edges(); ++b) {
        const auto& [i, j] = specimen.boundary_edges[b];
        const auto& p = specimen.node_position[static_cast<std::size_t>(i)];
        const auto& q = specimen.node_position[static_cast<std::size_t>(j)];
        lengths[specimen.boundary_part[b]] += std::hypot(q[0] - p[0], q[1] - p[1]);
    }
    std::string line = "  parts of the boundary:";
    bool is_first = true;
    for (std::size_t part = 0; part < lengths.size(); ++part) {
        if (lengths[part] == 0) continue;
        line += fmt::format("{} {} {}", is_first ? "" : ",", specimen.part_names[part], mm(lengths[part]));
        is_first = false;
    }
    return line;
}

}  // namespace

Import import_specimen(const ImportRequest& request, Fabric fabric, std::uint64_t seed) {
    const std::string bytes = read_bytes(request.file);
    Import import;
    import.digest = sha256_of(bytes);
    ImportedMesh mesh = import_mesh(bytes, request);
    import.format = mesh.format;
    import.labels = std::move(mesh.labels);
    import.specimen = assemble(std::move(mesh), request.placement, request.crystals, request.file == "-" ? "stdin" : request.file,
                               import.notes);
    if (import.has_phases()) {
        if (!fabric.phases.fractions.empty() && !fabric.phases.yield) {
            throw UsageError("--phases: the file says of what phases its grains are; leave the option out, or give --phase-key");
        }
        fabric.phases.fractions.clear();
    }
    std::vector<int> crystals = import.specimen.grain_crystal;
    const bool can_break = !crystals.empty();
    if (!can_break) {
        crystals.resize(import.specimen.n_grains());
        std::iota(crystals.begin(), crystals.end(), 0);
    }
    give_fabric(import.specimen, crystals, fabric, seed, 0, can_break);
    return import;
}

std::vector<std::string> write_new_key(const ImportRequest& request) {
    // Phases that were named by hand are not to be lost.
    if (request.new_key != request.phase_key && std::filesystem::is_regular_file(request.new_key)) {
        throw UsageError(
            fmt::format("--write-key: {0} is there already; give another name, or --phase-key {0} too, whose phases the "
                        "new key then has",
                        request.new_key));
    }
    const std::vector<LabelRow> rows = picture_labels(read_bytes(request.file), request);
    write_whole_file(request.new_key, key_of_labels(rows, request.file == "-" ? "stdin" : request.file));
    return describe_labels(rows);
}

std::vector<std::string> describe(const Import& import) {
    const Specimen& specimen = import.specimen;
    const MeshStatistics& s = specimen.statistics;
    std::vector<std::string> lines{
        fmt::format("{} of {} from {}: {} nodes, {} contacts, {} boundary edges", specimen.shape, grains_text(specimen),
                    import.format, specimen.n_nodes(), specimen.n_contacts(), specimen.n_boundary_edges()),
        fmt::format("  {} wide, {} high; edge mean {}, CV {:.4f}, min {}, max {}; smallest angle {:.1f} deg, psi6 {:.3f}",
                    mm(specimen.width), mm(specimen.height), mm(s.mean_edge), s.edge_variation, mm(s.min_edge), mm(s.max_edge),
                    s.min_angle * 180 / std::numbers::pi, s.psi6),
        parts_line(specimen),
    };
    const std::vector<double> fractions = phase_fractions(specimen);
    if (import.has_phases()) {
        std::string line = "  phases by area:";
        for (std::size_t p = 0; p < fractions.size(); ++p) {
            line += fmt::format("{} {} {:.4f}", p == 0 ? "" : ",", specimen.phase_names[p], fractions[p]);
        }
        lines.push_back(line);
    }
    if (const std::string open = open_boundaries_text(specimen); !open.empty()) lines.push_back("  open boundaries: " + open);
    if (!import.labels.empty()) {
        for (const std::string& line : describe_labels(import.labels)) lines.push_back(line);
    }
    if (specimen.n_elements() == specimen.n_grains() && s.psi6 > preferred) {
        lines.push_back(
            "  note: edges have preferred directions (psi6), which steer cracks; Gmsh's Mesh.Algorithm = 5 makes meshes without");
    }
    if (const std::string note = note_on_few_crystals(specimen); !note.empty()) lines.push_back("  note: " + note);
    for (const std::string& note : import.notes) lines.push_back("  note: " + note);
    return lines;
}

}  // namespace graincrack::mesher
