#include "post/commands/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "post/run/crystals.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/platen_faces.hpp"
#include "share/file/probe_file.hpp"
#include "share/file/provenance.hpp"
#include "share/file/run_file.hpp"
#include "share/file/schema.hpp"
#include "share/file/specimen_measures.hpp"
#include "share/options/option_set.hpp"
#include "share/rock/contact_parameters.hpp"

namespace graincrack {

namespace {

void line(std::ostream& out, const std::string& key, const std::string& value) {
    out << fmt::format("  {:<24} {}\n", key, printable(value));
}

/// An integer attribute, "unknown" if it is missing.
void write_integer(std::ostream& out, const H5Input& file, const char* group, const char* name) {
    line(out, name, file.has_attribute(group, name) ? std::to_string(file.attribute<std::int64_t>(group, name)) : "unknown");
}

/// Quantities of a group, if they are there.
void write_quantities(std::ostream& out, const H5Input& file, const char* group, Dimension dimension,
                      const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (file.has_attribute(group, name)) line(out, name, format_quantity(file.attribute<double>(group, name), dimension));
    }
}

/// How many rows a dataset has, 0 if it is missing.
std::string count_of(const H5Input& file, const std::string& path) {
    return std::to_string(file.has(path) ? graincrack::rows_of(file, path) : 0);
}

void write_counts(std::ostream& out, const H5Input& file) {
    line(out, "grains", count_of(file, schema::grain_phase.path));
    line(out, "elements", count_of(file, schema::element_nodes.path));
    line(out, "nodes", count_of(file, schema::node_position.path));
    line(out, "contacts", count_of(file, schema::contact_nodes.path));
    line(out, "boundary_edges", count_of(file, schema::boundary_edges.path));
}

/// Phases with their fractions of the area, if there are several.
void write_phases(std::ostream& out, const H5Input& file) {
    const char* path = schema::grain_phase.path;
    const auto names = file.attribute_or<std::vector<std::string>>(path, "names", {});
    const auto fractions = file.attribute_or<std::vector<double>>(path, "fractions", {});
    std::string phases;
    for (std::size_t p = 0; p < std::min(names.size(), fractions.size()); ++p) {
        phases += fmt::format("{}{} {:.4f}", p == 0 ? "" : ", ", names[p], fractions[p]);
    }
    if (!phases.empty()) line(out, "phases", phases);
}

/// Names of the parts that boundary edges have.
void write_parts(std::ostream& out, const H5Input& file) {
    const char* path = schema::boundary_part.path;
    const auto names = file.attribute_or<std::vector<std::string>>(path, "names", {});
    const std::vector<std::uint8_t> parts = file.has(path) ? file.read<std::uint8_t>(path) : std::vector<std::uint8_t>{};
    std::string used;
    for (std::size_t p = 0; p < names.size(); ++p) {
        if (std::find(parts.begin(), parts.end(), p) != parts.end()) used += (used.empty() ? "" : ", ") + names[p];
    }
    if (!used.empty()) line(out, "boundary_parts", used);
}

void write_crystals(std::ostream& out, const H5Input& file) {
    const auto sizes = crystal_sizes(file);
    if (!sizes) return;
    line(out, "crystals", std::to_string(sizes->n));
    line(out, "grain_size", format_quantity(sizes->mean_diameter, Dimension::length));
    line(out, "crystal_variation", format_number(sizes->variation, 4));
    line(out, "elements_per_crystal", format_number(sizes->elements, 4));
}

/// Flaws, joints and open boundaries, if there are any.
void write_flaws(std::ostream& out, const H5Input& file) {
    const char* path = schema::contact_kind.path;
    const std::vector<std::uint8_t> kinds = file.has(path) ? file.read<std::uint8_t>(path) : std::vector<std::uint8_t>{};
    if (std::none_of(kinds.begin(), kinds.end(), starts_broken) && !file.has(schema::contact_class.path)) return;
    const Specimen specimen = read_specimen(file);
    if (const std::string flaws = flaws_text(specimen); !flaws.empty()) line(out, "flaws", flaws);
    if (const std::string open = open_boundaries_text(specimen); !open.empty()) line(out, "open_boundaries", open);
}

void write_specimen_lines(std::ostream& out, const H5Input& file) {
    const char* group = schema::specimen_group;
    line(out, "shape", file.attribute_or<std::string>(group, "shape", "unknown"));
    write_quantities(out, file, group, Dimension::length, {"width", "height", "mean_edge"});
    write_quantities(out, file, group, Dimension::one, {"edge_variation"});
    write_quantities(out, file, group, Dimension::length, {"mean_diameter"});
    write_quantities(out, file, group, Dimension::one, {"diameter_variation", "elongation"});
    write_quantities(out, file, group, Dimension::angle, {"elongation_angle"});
    line(out, "tessellation", file.attribute_or<std::string>(group, "tessellation", "unknown"));
    if (const std::string asked = asked_grains(file); !asked.empty()) line(out, "asked_for", asked);
    write_integer(out, file, group, "seed");
    write_crystals(out, file);
    write_counts(out, file);
    write_parts(out, file);
    write_phases(out, file);
    write_flaws(out, file);
}

void write_run_lines(std::ostream& out, const H5Input& file) {
    const char* group = schema::run_group;
    const auto word = [&](const char* name) {
        const auto text = file.attribute_or<std::string>(group, name, "");
        line(out, name, text.empty() ? "unknown" : text);
    };
    for (const char* name : {"test", "plane", "material", "contact_law", "fracture_energy_choice"}) word(name);
    for (const ContactParameter& p : all_contact_parameters()) {
        write_quantities(out, file, group, p.quantity.dimension, {std::string(p.quantity.name)});
    }
    write_quantities(out, file, group, Dimension::stress, {"confining_pressure"});
    write_quantities(out, file, group, Dimension::temperature, {"heat"});
    if (file.has_attribute(group, "cooled")) write_integer(out, file, group, "cooled");
    word("rate");
    write_quantities(out, file, group, Dimension::speed, {"platen_speed"});
    write_quantities(out, file, group, Dimension::length, {"span"});
    write_quantities(out, file, group, Dimension::time, {"time_step"});
    write_integer(out, file, group, "steps");
    word("stop_reason");
    line(out, "history_rows", count_of(file, std::string(schema::history_group) + "/time"));
    line(out, "frames", std::to_string(file.has(schema::frames_group) ? file.children(schema::frames_group).size() : 0));
    line(out, "failed_contact_points", count_of(file, schema::crack_time.path));
}

void write_datasets(std::ostream& out, const H5Input& file) {
    out << "  datasets\n";
    for (const std::string& dataset : file.describe()) out << "    " << printable(dataset) << '\n';
}

/// Reads everything that tools read. A run from stdin, which can be read once only, is checked without its cracks and frames.
void check_file(const H5Input& file, const std::string& path) {
    file.check();
    (void)read_specimen(file);
    if (file.kind() != "run") return;
    (void)read_history(file);
    (void)read_sensitivity(file);
    for (const std::string& probe : probe_names(file)) (void)read_probe(file, probe);
    if (path == "-") return;
    const RunReader run(path);
    (void)read_platen_faces(file, run.specimen());
    (void)run.cracks();
    (void)run.frame_times();
    for (std::size_t i = 0; i < run.n_frames(); ++i) (void)run.frame(i);
}

/// For a person: kind, attributes, counts and datasets. \param check also reads every dataset and validates the specimen
void write_info(std::ostream& out, const std::string& path, bool check) {
    const H5Input file(path);
    if (check) check_file(file, path);
    out << printable(file.name()) << '\n';
    line(out, "kind", fmt::format("{}, schema {}", file.kind(), file.attribute<std::int64_t>("/", "schema_version")));
    if (file.has_attribute("/provenance", "commit")) {
        line(out, "made_by",
             fmt::format("version {} ({})", file.attribute<std::string>("/provenance", "version"),
                         file.attribute<std::string>("/provenance", "commit")));
    }
    const auto source = file.attribute_or<std::string>("/provenance", "input_digest", "");
    if (file.kind() == "specimen" && !source.empty()) line(out, "imported_from", "SHA-256 " + source);
    if (file.kind() == "run") write_run_lines(out, file);
    write_specimen_lines(out, file);
    write_datasets(out, file);
    if (check) {
        line(out, "check",
             std::string("every dataset was read; valid are sizes, elements, grains, contacts and boundary of the specimen") +
                 (file.kind() != "run" ? ""
                  : path == "-"        ? "; history and probes of the run"
                                       : "; header, history, probes, platens, cracks and frames of the run"));
    }
}

/// `digest  file`, as sha256sum prints it.
void write_digest(std::ostream& out, const std::string& path, bool check) {
    const H5Input file(path);
    if (check) check_file(file, path);
    out << file.digest() << "  " << (path == "-" ? "-" : printable(file.name())) << '\n';
}

struct InfoOptions {
    bool check = false;
    bool digest = false;
};

void add_info_options(OptionSet set, InfoOptions& options) {
    add_flag(set, "--check", options.check, "read every dataset and validate the specimen");
    add_flag(set, "--digest", options.digest, "print the digest of the file alone: SHA-256 over the content except /provenance");
}

void show_info(const InfoOptions& options, const Call& call) {
    for (const std::string& file : call.files) (options.digest ? write_digest : write_info)(call.out, file, options.check);
}

}  // namespace

Command info_command() {
    return make_command<InfoOptions>("info", "contents of a specimen or run", {"uniaxial.h5", "disc.h5 --check"},
                                     FileArguments{"files", "specimens or runs", true, true}, add_info_options, show_info);
}

}  // namespace graincrack
