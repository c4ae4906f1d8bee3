#include <fmt/format.h>

#include <algorithm>

#include "share/base/error.hpp"
#include "share/base/sha256.hpp"
#include "share/file/h5_detail.hpp"
namespace graincrack::h5 {
namespace {

/// Type in memory in which values are hashed: the same on every machine.
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

/// Names of the attributes of an object, sorted; false if one of them is damaged.
/// The iteration frees its table twice where an attribute cannot be decoded (HDF5 1.10.8). Looking up a name that there is not
/// decodes all attributes, and fails where one cannot be.
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

/// Walks through a file whose groups are a tree (`require_tree`).
class Content {
public:
    Content(hid_t file, const std::string& file_name) : file_(file), file_name_(file_name) {}

    /// Adds an object and all below it to a hash, but for the object `left_out`.
    void digest(const std::string& path, const std::string& left_out, Sha256& hash) const {
        const Handle object = open(path);
        if (H5Iget_type(object.get()) == H5I_GROUP) {
            hash.add(path + " group");
            digest_attributes(object.get(), path, hash);
            for (const std::string& child : children_of(path)) {
                if (child != left_out) digest(child, left_out, hash);
            }
            return;
        }
        hash.add(path + " " + shape_of(object.get()));
        digest_attributes(object.get(), path, hash);
        digest_values(object.get(), path, hash);
    }

    /// Adds a line for each dataset.
    void describe(const std::string& path, std::vector<std::string>& lines) const {
        const Handle object = open(path);
        if (H5Iget_type(object.get()) == H5I_GROUP) {
            for (const std::string& child : children_of(path)) describe(child, lines);
            return;
        }
        std::string line = path + " " + shape_of(object.get());
        for (const char* name : {"unit", "description"}) {
            std::string text;
            const Handle attribute(H5Aexists(object.get(), name) > 0 ? H5Aopen(object.get(), name, H5P_DEFAULT) : -1, H5Aclose);
            if (attribute.valid()) {
                require_readable_attribute(attribute.get(), file_name_, path, name);
                line += read_attribute(attribute.get(), text) ? " " + text : "";
            }
        }
        lines.push_back(line);
    }

private:
    [[nodiscard]] Handle open(const std::string& path) const {
        Handle object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
        if (!object.valid()) throw InputError(fmt::format("{}: {} cannot be read", file_name_, path));
        return object;
    }
    [[nodiscard]] std::vector<std::string> children_of(const std::string& path) const {
        std::vector<std::string> children = link_names(file_, path);
        for (std::string& child : children) child = (path == "/" ? "" : path) + "/" + child;
        return children;
    }
    /// Type and extents.
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
    Content(file, file_name).digest("/", left_out, hash);
    return hash.hex();
}

std::vector<std::string> describe(hid_t file, const std::string& file_name) {
    std::vector<std::string> lines;
    Content(file, file_name).describe("/", lines);
    return lines;
}

}  // namespace graincrack::h5
