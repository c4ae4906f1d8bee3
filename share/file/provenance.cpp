#include "share/file/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <ctime>

#include "share/file/h5_file.hpp"

namespace graincrack {

std::string project_version() { return GRAINCRACK_VERSION; }
std::string project_commit() { return GRAINCRACK_COMMIT; }

std::vector<std::string> library_versions() {
    return {
        "HDF5 " + hdf5_version(), fmt::format("fmt {}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100),
#if defined(__clang__)
            fmt::format("clang {}", __clang_version__)
#else
            fmt::format("gcc {}", __VERSION__)
#endif
    };
}

namespace {

std::string host_name() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string utc_time() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

}  // namespace

void write_provenance(H5Output& file, const Provenance& provenance) {
    const std::string group = "/provenance";
    file.create_group(group);
    file.attribute(group, "tool", provenance.tool);
    file.attribute(group, "version", project_version());
    file.attribute(group, "commit", project_commit());
    file.attribute(group, "command_line", provenance.command_line);
    file.attribute(group, "configuration", provenance.configuration);
    if (!provenance.material.empty()) file.attribute(group, "material", provenance.material);
    file.attribute(group, "host", host_name());
    file.attribute(group, "utc_time", utc_time());
    file.attribute(group, "libraries", provenance.libraries.empty() ? library_versions() : provenance.libraries);
    file.attribute(group, "input_digest", provenance.input_digest);
    if (!provenance.vector_target.empty()) file.attribute(group, "vector_target", provenance.vector_target);
    file.quantity(group, "wall_time", provenance.wall_time, "s");
    file.attribute(group, "threads", std::int64_t{provenance.threads});
    file.attribute(group, "ranks", std::int64_t{provenance.ranks});
}

}  // namespace graincrack
