#include "share/file/probe_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "share/base/error.hpp"
#include "share/base/units.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"

namespace graincrack {
namespace {

std::string group_of(const std::string& probe) { return std::string(schema::probes_group) + "/" + probe; }

}  // namespace

std::string point_of_ring(const std::string& ring, std::size_t point) { return fmt::format("{}.{:03}", ring, point); }

void append_probes(H5Output& file, const std::vector<ProbeHistory>& probes, std::size_t first) {
    for (const ProbeHistory& probe : probes) {
        if (probe.values.front().size() == first && first > 0) {
            continue;  // nothing new
        }
        for (std::size_t c = 0; c < probe.columns.size(); ++c) {
            const ProbeColumn& column = probe.columns[c];
            const std::size_t n = probe.values[c].size() - first;
            file.append<double>(group_of(probe.name) + "/" + column.name, std::span(probe.values[c].data() + first, n), {n},
                                si_unit(column.dimension), column.description);
        }
    }
}

std::vector<std::string> probe_names(const H5Input& file) {
    return file.has(schema::probes_group) ? file.children(schema::probes_group) : std::vector<std::string>{};
}

ProbeHistory read_probe(const H5Input& file, const std::string& name) {
    const std::vector<std::string> names = probe_names(file);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw InputError(names.empty()
                             ? fmt::format("{}: has no probes; a run of `graincrack-solve program` may", file.name())
                             : fmt::format("{}: there is no probe {}; there are {}", file.name(), name, fmt::join(names, ", ")));
    }
    ProbeHistory probe{name, {}, {}};
    for (const std::string& column : file.children(group_of(name))) {
        const std::string path = group_of(name) + "/" + column;
        probe.columns.push_back({column, dimension_of_unit(file.attribute<std::string>(path, "unit")).value_or(Dimension::one),
                                 file.attribute<std::string>(path, "description")});
        const std::size_t rows = rows_of(file, path);
        probe.values.push_back(read_finite(file, path, {probe.values.empty() ? rows : probe.values.front().size()}));
    }
    if (probe.values.empty()) throw InputError(fmt::format("{}: probe {} has no columns", file.name(), name));
    return probe;
}

}  // namespace graincrack
