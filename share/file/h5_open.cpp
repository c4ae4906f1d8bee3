#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>
#include <limits>
#include <set>

#include "share/base/error.hpp"
#include "share/file/h5_detail.hpp"

namespace graincrack::h5 {
namespace {

constexpr std::size_t max_depth = 16;                          // of groups; ours are three deep
constexpr std::size_t max_chunk_bytes = std::size_t{1} << 26;  // of a chunk; ours have 256 KiB or a row
constexpr std::size_t max_deflation = 1100;  // deflate makes 1,032 bytes of one at most; some are the library's own

std::size_t size_of_file(hid_t object) {
    const Handle file(H5Iget_file_id(object), H5Fclose);
    hsize_t size = 0;
    return file.valid() && H5Fget_filesize(file.get(), &size) >= 0 ? static_cast<std::size_t>(size) : 0;
}

/// Product of extents, the largest number if it is beyond that.
std::size_t product_of(const Extents& extents) {
    std::size_t n = 1;
    for (const std::size_t e : extents) {
        n = e != 0 && n > std::numeric_limits<std::size_t>::max() / e ? std::numeric_limits<std::size_t>::max() : n * e;
    }
    return n;
}

/// How the values of a dataset are kept: false where it is not in this file, or by filters that ours do not have.
bool is_kept_plainly(hid_t properties) {
    const H5D_layout_t layout = H5Pget_layout(properties);
    const bool is_known = layout == H5D_COMPACT || layout == H5D_CONTIGUOUS || layout == H5D_CHUNKED;
    if (!is_known || H5Pget_external_count(properties) > 0) return false;
    for (int i = 0; i < H5Pget_nfilters(properties); ++i) {
        unsigned flags = 0;
        std::size_t n_values = 0;
        const H5Z_filter_t filter =
            H5Pget_filter2(properties, static_cast<unsigned>(i), &flags, &n_values, nullptr, 0, nullptr, nullptr);
        if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_FLETCHER32) return false;
    }
    return true;
}

/// Values of a chunk; 1 where there are no chunks.
std::size_t chunk_values(hid_t properties) {
    if (H5Pget_layout(properties) != H5D_CHUNKED) return 1;
    std::vector<hsize_t> extents(H5S_MAX_RANK);
    const int rank = H5Pget_chunk(properties, H5S_MAX_RANK, extents.data());
    extents.resize(static_cast<std::size_t>(std::max(rank, 0)));
    return product_of({extents.begin(), extents.end()});
}

bool has_signature(const std::vector<char>& bytes) {
    static constexpr unsigned char signature[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    return bytes.size() >= sizeof signature && std::memcmp(bytes.data(), signature, sizeof signature) == 0;
}

/// \throws InputError where the library could not open a file. \param is_hdf5 whether it begins as a file of HDF5
Handle opened(Handle file, const std::string& name, bool is_hdf5) {
    if (file.valid()) return file;
    throw InputError(name + (is_hdf5 ? ": truncated or damaged HDF5 file; write it again with the tool that made it"
                                     : ": not an HDF5 file; a file written by a Graincrack tool is needed"));
}

}  // namespace

std::vector<char> read_stdin() {
    std::vector<char> bytes;
    std::vector<char> buffer(1 << 20);
    while (true) {
        const ssize_t n = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw InputError(fmt::format("stdin: cannot be read: {}", std::strerror(errno)));
        if (n == 0) return bytes;
        bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + n);
    }
}

// By the core driver, which keeps a copy of its own. (H5LTopen_file_image makes no copy, but leaks.)
Handle open_image(const std::vector<char>& bytes, const std::string& name) {
    if (bytes.empty()) throw InputError("stdin: empty: the program before wrote nothing; see its message");
    const Handle access = property_list(H5P_FILE_ACCESS);
    H5Pset_fapl_core(access.get(), 1 << 20, 0);
    H5Pset_file_image(access.get(), const_cast<char*>(bytes.data()),
                      bytes.size());  // NOLINT: the C interface takes it non-const, and copies
    return opened({H5Fopen("graincrack-stdin", H5F_ACC_RDONLY, access.get()), H5Fclose}, name, has_signature(bytes));
}

Handle open_path(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        throw InputError(fmt::format("{}: {}", path, errno == ENOENT ? "no such file" : std::strerror(errno)));
    }
    if (S_ISDIR(status.st_mode)) throw InputError(fmt::format("{}: is a folder, an HDF5 file is needed", path));
    if (::access(path.c_str(), R_OK) != 0) throw InputError(fmt::format("{}: {}", path, std::strerror(errno)));
    if (status.st_size == 0) throw InputError(fmt::format("{}: empty file, a file written by a Graincrack tool is needed", path));
    return opened({H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose}, path, H5Fis_hdf5(path.c_str()) > 0);
}

void require_tree(hid_t file, const std::string& file_name) {
    std::set<haddr_t> groups;
    const std::function<void(const std::string&, std::size_t)> visit = [&](const std::string& path, std::size_t depth) {
        const auto require = [&](bool holds, const std::string& of, const char* what) {
            if (holds) return;
            throw InputError(
                fmt::format("{}: {} {}; write the file again with the tool that made it", file_name, of.substr(0, 80), what));
        };
        require(depth <= max_depth, path, "is nested deeper than any group of a file of ours");
        H5O_info_t info;
        require(H5Oget_info_by_name2(file, path.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) >= 0, path, "cannot be read");
        if (info.type == H5O_TYPE_DATASET) return;
        require(info.type == H5O_TYPE_GROUP, path, "is neither a group nor a dataset");
        require(groups.insert(info.addr).second, path, "is a group with two links, perhaps in a circle");
        std::vector<Link> links;
        require(links_of(file, path, links), path, "cannot be read");
        for (const Link& link : links) {
            const std::string child = (path == "/" ? "" : path) + "/" + link.name;
            require(link.is_hard, child, "is a soft or external link");
            visit(child, depth + 1);
        }
    };
    visit("/", 0);
}

std::size_t require_readable(hid_t dataset, const std::string& file_name, const std::string& path) {
    const auto require = [&](bool holds, const char* what) {
        if (!holds) {
            throw InputError(
                fmt::format("{}: dataset {} {}; write the file again with the tool that made it", file_name, path, what));
        }
    };
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const Handle space = space_of_dataset(dataset);
    const Handle properties(H5Dget_create_plist(dataset), H5Pclose);
    require(type.valid() && space.valid() && properties.valid(), "is damaged");
    const H5T_class_t kind = H5Tget_class(type.get());
    require(kind == H5T_INTEGER || kind == H5T_FLOAT, "holds no numbers");
    require(is_kept_plainly(properties.get()), "is kept in another file or by an unknown filter");
    if (H5Sget_simple_extent_type(space.get()) == H5S_NULL) return 0;
    const std::size_t n = product_of(space_extents(space.get()));
    const std::size_t item = H5Tget_size(type.get());
    const std::size_t stored = std::min<std::size_t>(H5Dget_storage_size(dataset), size_of_file(dataset));
    const std::size_t most = H5Pget_layout(properties.get()) == H5D_CHUNKED ? stored * max_deflation : stored;
    require(n <= most / item, "declares more values than its file holds");
    require(chunk_values(properties.get()) <= max_chunk_bytes / item, "has chunks beyond any of ours");
    return n;
}

void require_readable_attribute(hid_t attribute, const std::string& file_name, const std::string& object,
                                const std::string& name) {
    const Handle type = type_of_attribute(attribute);
    const Handle space = space_of_attribute(attribute);
    const auto require = [&](bool holds, const char* what) {
        if (!holds) throw InputError(fmt::format("{}: attribute {} of {} {}", file_name, name, object, what));
    };
    require(type.valid() && space.valid(), "is damaged");
    const H5T_class_t kind = H5Tget_class(type.get());
    const bool is_variable = kind == H5T_VLEN || H5Tis_variable_str(type.get()) > 0;
    require(kind == H5T_INTEGER || kind == H5T_FLOAT || kind == H5T_STRING, "is neither a number nor a text");
    require(!is_variable,
            "is a text of variable length; one of fixed length is needed (h5py: numpy.bytes_(text), or an array of type S)");
    if (H5Sget_simple_extent_type(space.get()) != H5S_NULL) {
        const std::size_t n = product_of(space_extents(space.get()));
        require(n <= size_of_file(attribute) / std::max<std::size_t>(H5Tget_size(type.get()), 1),
                "declares more values than its file holds");
    }
}

}  // namespace graincrack::h5
