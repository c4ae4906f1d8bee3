#include "share/file/h5_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "share/base/error.hpp"

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

struct Link {
    std::string name;
    bool is_hard;
};
herr_t collect_link(hid_t /*group*/, const char* name, const H5L_info_t* info, void* data) {
    static_cast<std::vector<Link>*>(data)->push_back({name, info->type == H5L_TYPE_HARD});
    return 0;
}

class Walk {
public:
    Walk(hid_t file, const std::string& file_name) : file_(file), file_name_(file_name) {}
    void visit(const std::string& path, std::size_t depth) {
        require(depth <= max_depth, path, "is nested deeper than any group of a file of ours");
        H5O_info_t info;
        require(H5Oget_info_by_name2(file_, path.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) >= 0, path, "cannot be read");
        if (info.type == H5O_TYPE_DATASET) return;
        require(info.type == H5O_TYPE_GROUP, path, "is neither a group nor a dataset");
        require(groups_.insert(info.addr).second, path, "is a group with two links, perhaps in a circle");
        for (const Link& link : links_of(path)) {
            const std::string child = (path == "/" ? "" : path) + "/" + link.name;
            require(link.is_hard, child, "is a soft or external link");
            visit(child, depth + 1);
        }
    }

private:
    [[nodiscard]] std::vector<Link> links_of(const std::string& path) const {
        std::vector<Link> links;
        hsize_t start = 0;
        const Handle group(H5Gopen2(file_, path.c_str(), H5P_DEFAULT), H5Gclose);
        const bool read =
            group.valid() && H5Literate(group.get(), H5_INDEX_NAME, H5_ITER_NATIVE, &start, collect_link, &links) >= 0;
        require(read, path, "cannot be read");
        return links;
    }
    void require(bool holds, const std::string& path, const char* what) const {
        if (!holds) {
            throw InputError(
                fmt::format("{}: {} {}; write the file again with the tool that made it", file_name_, path.substr(0, 80), what));
        }
    }

    hid_t file_;
    const std::string& file_name_;
    std::set<haddr_t> groups_;
};

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

}  // namespace

void require_tree(hid_t file, const std::string& file_name) { Walk(file, file_name).visit("/", 0); }

std::size_t require_readable(hid_t dataset, const std::string& file_name, const std::string& path) {
    const auto require = [&](bool holds, const char* what) {
        if (!holds) {
            throw InputError(
                fmt::format("{}: dataset {} {}; write the file again with the tool that made it", file_name, path, what));
        }
    };
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const Handle space(H5Dget_space(dataset), H5Sclose);
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
    const Handle type(H5Aget_type(attribute), H5Tclose);
    const Handle space(H5Aget_space(attribute), H5Sclose);
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
