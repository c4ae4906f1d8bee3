#include "share/file/h5_detail.hpp"

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
#include "share/base/sha256.hpp"
#include "share/base/text.hpp"

namespace graincrack::h5 {

namespace {

Handle fixed_string_type(std::size_t size) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    return type;
}

}  // namespace

Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose}; }
Handle vector_space(std::size_t n) {
    const hsize_t extent = n;
    return {H5Screate_simple(1, &extent, nullptr), H5Sclose};
}

Handle type_of_attribute(hid_t attribute) { return {H5Aget_type(attribute), H5Tclose}; }
Handle space_of_attribute(hid_t attribute) { return {H5Aget_space(attribute), H5Sclose}; }
Handle space_of_dataset(hid_t dataset) { return {H5Dget_space(dataset), H5Sclose}; }

void write_numbers(hid_t object, const std::string& name, hid_t type, const Handle& space, const void* values) {
    if (H5Aexists(object, name.c_str()) > 0) H5Adelete(object, name.c_str());
    const Handle attribute(H5Acreate2(object, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const bool is_empty = H5Sget_simple_extent_npoints(space.get()) == 0;  // HDF5 cannot write an empty list of texts
    if (!attribute.valid() || (!is_empty && H5Awrite(attribute.get(), type, values) < 0)) {
        throw OutputError(fmt::format("attribute {} cannot be written", name));
    }
}

void write_texts(hid_t object, const std::string& name, const std::vector<std::string>& values, const Handle& space) {
    std::size_t size = 1;
    for (const std::string& value : values) size = std::max(size, value.size());
    std::string padded;
    for (const std::string& value : values) padded += value + std::string(size - value.size(), '\0');
    write_numbers(object, name, fixed_string_type(size).get(), space, padded.data());
}

bool read_attribute(hid_t attribute, std::vector<std::string>& out) {
    const Handle type = type_of_attribute(attribute);
    if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0) return false;
    const auto n = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space_of_attribute(attribute).get()));
    out.clear();
    const std::size_t size = H5Tget_size(type.get());
    std::vector<char> bytes(n * size);
    if (n > 0 && H5Aread(attribute, type.get(), bytes.data()) < 0) return false;
    for (std::size_t i = 0; i < n; ++i) {
        const char* begin = bytes.data() + i * size;
        out.emplace_back(begin, strnlen(begin, size));
    }
    return true;
}

namespace {

herr_t collect_link(hid_t /*group*/, const char* name, const H5L_info_t* info, void* data) {
    static_cast<std::vector<Link>*>(data)->push_back({name, info->type == H5L_TYPE_HARD});
    return 0;
}

}  // namespace

bool links_of(hid_t file, const std::string& group, std::vector<Link>& links) {
    hsize_t start = 0;
    const Handle id(H5Gopen2(file, group.c_str(), H5P_DEFAULT), H5Gclose);
    if (!id.valid() || H5Literate(id.get(), H5_INDEX_NAME, H5_ITER_INC, &start, collect_link, &links) < 0) return false;
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) { return a.name < b.name; });
    return true;
}

std::vector<std::string> link_names(hid_t file, const std::string& group) {
    std::vector<Link> links;
    std::vector<std::string> names;
    links_of(file, group, links);
    for (const Link& link : links) names.push_back(link.name);
    return names;
}

std::string type_name(hid_t type) {
    const std::size_t bytes = H5Tget_size(type);
    switch (H5Tget_class(type)) {
        case H5T_INTEGER: return fmt::format("{}int{}", H5Tget_sign(type) == H5T_SGN_NONE ? "u" : "", 8 * bytes);
        case H5T_FLOAT: return fmt::format("float{}", 8 * bytes);
        case H5T_STRING: return "string";
        default: return "other";
    }
}

Extents space_extents(hid_t space) {
    const int rank = H5Sget_simple_extent_ndims(space);
    std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return {extents.begin(), extents.end()};
}

std::string extents_text(const Extents& extents) {
    std::string text = "[";
    for (std::size_t i = 0; i < extents.size(); ++i) text += (i > 0 ? "," : "") + std::to_string(extents[i]);
    return text + "]";
}

// --- opening and checking -------------------------------------------------------------------------------------------

namespace {

constexpr std::size_t max_depth = 16;                          // nesting of groups; this project's files have three levels
constexpr std::size_t max_chunk_bytes = std::size_t{1} << 26;  // size of a chunk; this project's have 256 KiB or one row
constexpr std::size_t max_deflation = 1100;                    // deflate expands up to 1,032-fold; some bytes are the library's

std::size_t size_of_file(hid_t object) {
    const Handle file(H5Iget_file_id(object), H5Fclose);
    hsize_t size = 0;
    return file.valid() && H5Fget_filesize(file.get(), &size) >= 0 ? static_cast<std::size_t>(size) : 0;
}

/// Product of extents, or the largest number if it overflows.
std::size_t product_of(const Extents& extents) {
    std::size_t n = 1;
    for (const std::size_t e : extents) {
        n = e != 0 && n > std::numeric_limits<std::size_t>::max() / e ? std::numeric_limits<std::size_t>::max() : n * e;
    }
    return n;
}

/// True if the values of a dataset are in this file, with filters that this project uses.
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

/// Number of values of a chunk; 1 without chunks.
std::size_t chunk_values(hid_t properties) {
    if (H5Pget_layout(properties) != H5D_CHUNKED) return 1;
    std::vector<hsize_t> extents(H5S_MAX_RANK);
    const int rank = H5Pget_chunk(properties, H5S_MAX_RANK, extents.data());
    extents.resize(static_cast<std::size_t>(std::max(rank, 0)));
    return product_of({extents.begin(), extents.end()});
}

bool has_signature(std::span<const char> bytes) {
    static constexpr unsigned char signature[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    return bytes.size() >= sizeof signature && std::memcmp(bytes.data(), signature, sizeof signature) == 0;
}

/// Checks that the library has opened a file. \throws InputError if not \param is_hdf5 true if it begins like HDF5
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

// The core driver keeps a copy of its own; H5LTopen_file_image makes no copy, but leaks.
Handle open_image(std::span<const char> bytes, const std::string& name) {
    if (bytes.empty()) throw InputError(name + ": empty: the program before wrote nothing; see its message");
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
    if (!S_ISREG(status.st_mode)) {
        return open_image(text_of_file(path, longest_text, "; a file written by a Graincrack tool is needed"), path);
    }
    if (status.st_size == 0) throw InputError(fmt::format("{}: empty file, a file written by a Graincrack tool is needed", path));
    return opened({H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose}, path, H5Fis_hdf5(path.c_str()) > 0);
}

namespace {

void require(bool holds, const std::string& file_name, const std::string& object, const char* what) {
    constexpr const char* right = "write the file again with the tool that made it";
    if (!holds) throw InputError(fmt::format("{}: {} {}; {}", file_name, object, what, right));
}

}  // namespace

void require_tree(hid_t file, const std::string& file_name) {
    std::set<haddr_t> groups;
    const std::function<void(const std::string&, std::size_t)> visit = [&](const std::string& path, std::size_t depth) {
        const std::string shown = path.substr(0, 80);
        require(depth <= max_depth, file_name, shown, "is nested deeper than any group of a file of ours");
        H5O_info_t info;
        require(H5Oget_info_by_name2(file, path.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) >= 0, file_name, shown,
                "cannot be read");
        if (info.type == H5O_TYPE_DATASET) return;
        require(info.type == H5O_TYPE_GROUP, file_name, shown, "is neither a group nor a dataset");
        require(groups.insert(info.addr).second, file_name, shown, "is a group with two links, perhaps in a circle");
        std::vector<Link> links;
        require(links_of(file, path, links), file_name, shown, "cannot be read");
        for (const Link& link : links) {
            const std::string child = (path == "/" ? "" : path) + "/" + link.name;
            require(link.is_hard, file_name, child.substr(0, 80), "is a soft or external link");
            visit(child, depth + 1);
        }
    };
    visit("/", 0);
}

std::size_t require_readable(hid_t dataset, const std::string& file_name, const std::string& path) {
    const auto require_dataset = [&](bool holds, const char* what) { require(holds, file_name, "dataset " + path, what); };
    const Handle type(H5Dget_type(dataset), H5Tclose);
    const Handle space = space_of_dataset(dataset);
    const Handle properties(H5Dget_create_plist(dataset), H5Pclose);
    require_dataset(type.valid() && space.valid() && properties.valid(), "is damaged");
    const H5T_class_t kind = H5Tget_class(type.get());
    require_dataset(kind == H5T_INTEGER || kind == H5T_FLOAT, "holds no numbers");
    require_dataset(is_kept_plainly(properties.get()), "is kept in another file or by an unknown filter");
    if (H5Sget_simple_extent_type(space.get()) == H5S_NULL) return 0;
    const std::size_t n = product_of(space_extents(space.get()));
    const std::size_t item = H5Tget_size(type.get());
    const std::size_t stored = std::min<std::size_t>(H5Dget_storage_size(dataset), size_of_file(dataset));
    const std::size_t most = H5Pget_layout(properties.get()) == H5D_CHUNKED ? stored * max_deflation : stored;
    require_dataset(n <= most / item, "declares more values than its file holds");
    require_dataset(chunk_values(properties.get()) <= max_chunk_bytes / item, "has chunks beyond any of ours");
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

// --- digest and list of the content ---------------------------------------------------------------------------------

namespace {

/// Type in memory of hashed values, which is the same on every machine.
hid_t hash_type(hid_t type) {
    switch (H5Tget_class(type)) {
        case H5T_INTEGER: return H5Tget_size(type) == 1 ? H5T_STD_U8LE : H5T_STD_I64LE;
        case H5T_FLOAT: return H5T_IEEE_F64LE;
        default: return -1;
    }
}

herr_t collect_attribute(hid_t /*object*/, const char* name, const H5A_info_t* /*info*/, void* data) {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
}

/// Names of the attributes of an object, sorted; false if one of them is damaged. The library's iteration frees its table twice
/// if an attribute cannot be decoded (HDF5 1.10.8). Looking up an absent name decodes all attributes, and fails if one cannot be
/// decoded.
bool attribute_names(hid_t object, std::vector<std::string>& names) {
    constexpr const char* absent = "\x01";
    hsize_t start = 0;
    names.clear();
    if (H5Aexists(object, absent) < 0 || H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &start, collect_attribute, &names) < 0) {
        return false;
    }
    std::sort(names.begin(), names.end());
    return true;
}

/// Visits a file whose groups are a tree (`require_tree`).
class Content {
public:
    Content(hid_t file, const std::string& file_name) : file_(file), file_name_(file_name) {}

    /// Adds all objects to a hash, except the object `left_out` and those below it.
    void digest(const std::string& left_out, Sha256& hash) const {
        walk("/", left_out, [&](hid_t object, const std::string& path, bool is_group) {
            hash.add(path + " " + (is_group ? "group" : shape_of(object)));
            digest_attributes(object, path, hash);
            if (!is_group) digest_values(object, path, hash);
        });
    }

    /// Returns one line per dataset.
    [[nodiscard]] std::vector<std::string> describe() const {
        std::vector<std::string> lines;
        walk("/", "", [&](hid_t object, const std::string& path, bool is_group) {
            if (is_group) return;
            std::string line = path + " " + shape_of(object);
            for (const char* name : {"unit", "description"}) {
                std::string text;
                const Handle attribute(H5Aexists(object, name) > 0 ? H5Aopen(object, name, H5P_DEFAULT) : -1, H5Aclose);
                if (!attribute.valid()) continue;
                require_readable_attribute(attribute.get(), file_name_, path, name);
                line += read_attribute(attribute.get(), text) ? " " + text : "";
            }
            lines.push_back(line);
        });
        return lines;
    }

private:
    /// Calls `visit(object, path, is_group)` with an object, and then with all objects below it.
    template <class Visit>
    void walk(const std::string& path, const std::string& left_out, const Visit& visit) const {
        const Handle object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
        if (!object.valid()) throw InputError(fmt::format("{}: {} cannot be read", file_name_, path));
        const bool is_group = H5Iget_type(object.get()) == H5I_GROUP;
        visit(object.get(), path, is_group);
        for (const std::string& name : is_group ? link_names(file_, path) : std::vector<std::string>{}) {
            const std::string child = (path == "/" ? "" : path) + "/" + name;
            if (child != left_out) walk(child, left_out, visit);
        }
    }
    /// Type and extents of a dataset as text.
    static std::string shape_of(hid_t dataset) {
        const Handle type(H5Dget_type(dataset), H5Tclose);
        return type_name(type.get()) + " " + extents_text(space_extents(space_of_dataset(dataset).get()));
    }
    void digest_attributes(hid_t object, const std::string& path, Sha256& hash) const {
        std::vector<std::string> names;
        if (!attribute_names(object, names)) {
            throw InputError(fmt::format("{}: the attributes of {} cannot be read: the file is damaged", file_name_, path));
        }
        for (const std::string& name : names) {
            const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
            const auto refuse = [&] {
                throw InputError(fmt::format("{}: attribute {} of {} cannot be read", file_name_, name, path));
            };
            if (!attribute.valid()) refuse();
            require_readable_attribute(attribute.get(), file_name_, path, name);
            const Handle type = type_of_attribute(attribute.get());
            const Handle space = space_of_attribute(attribute.get());
            hash.add("@" + name + " " + type_name(type.get()) + " " + extents_text(space_extents(space.get())));
            std::vector<std::string> texts;
            if (read_attribute(attribute.get(), texts)) {
                for (const std::string& text : texts) hash.add(text);
            } else if (const hid_t as = hash_type(type.get()); as >= 0) {
                std::vector<char> bytes(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())) * H5Tget_size(as));
                if (!bytes.empty() && H5Aread(attribute.get(), as, bytes.data()) < 0) refuse();
                hash.add(bytes.data(), bytes.size());
            }
        }
    }
    void digest_values(hid_t dataset, const std::string& path, Sha256& hash) const {
        const std::size_t n = require_readable(dataset, file_name_, path);
        const Handle type(H5Dget_type(dataset), H5Tclose);
        const hid_t as = hash_type(type.get());
        std::vector<char> bytes(n * H5Tget_size(as));
        if (n > 0 && H5Dread(dataset, as, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) {
            throw InputError(fmt::format("{}: {} cannot be read: the file is damaged", file_name_, path));
        }
        hash.add(bytes.data(), bytes.size());
    }

    hid_t file_;
    const std::string& file_name_;
};

}  // namespace

std::string digest(hid_t file, const std::string& file_name, const std::string& left_out) {
    Sha256 hash;
    Content(file, file_name).digest(left_out, hash);
    return hash.hex();
}

std::vector<std::string> describe(hid_t file, const std::string& file_name) { return Content(file, file_name).describe(); }

}  // namespace graincrack::h5
