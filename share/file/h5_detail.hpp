// Internals of reading and writing HDF5: identifiers that close themselves, types, attributes, checks of files before their
// content is used, and their digest. Only share/file/h5_*.cpp include it.
#pragma once

#include <hdf5.h>

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "share/file/h5_file.hpp"

namespace graincrack::h5 {

/// An HDF5 identifier that closes itself.
class Handle {
public:
    Handle() = default;
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, -1);
            close_ = other.close_;
        }
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    [[nodiscard]] hid_t get() const { return id_; }
    [[nodiscard]] bool valid() const { return id_ >= 0; }
    /// Closes it. \return false if it cannot be closed
    bool reset() {
        const hid_t id = std::exchange(id_, -1);
        return id < 0 || close_(id) >= 0;
    }

private:
    hid_t id_ = -1;
    herr_t (*close_)(hid_t) = nullptr;
};

inline Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

static_assert(std::endian::native == std::endian::little, "numbers in memory are those of files");
/// HDF5 type of a C++ type, in files and in memory.
template <class T>
hid_t number_type() {
    if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
    if constexpr (std::is_same_v<T, std::int32_t>) return H5T_STD_I32LE;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
    if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_STD_U8LE;
}

Handle scalar_space();
Handle vector_space(std::size_t n);
Handle type_of_attribute(hid_t attribute);
Handle space_of_attribute(hid_t attribute);
Handle space_of_dataset(hid_t dataset);

/// Writes or replaces an attribute of numbers.
void write_numbers(hid_t object, const std::string& name, hid_t type, const Handle& space, const void* values);
/// Writes or replaces an attribute of fixed-length texts, as VTK's readers require in /VTKHDF.
void write_texts(hid_t object, const std::string& name, const std::vector<std::string>& values, const Handle& space);
/// Writes or replaces an attribute: a number, a text, or a list of either.
template <class T>
void write_attribute(hid_t object, const std::string& name, const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
        write_numbers(object, name, number_type<T>(), scalar_space(), &value);
    } else if constexpr (std::is_same_v<T, std::string>) {
        write_texts(object, name, {value}, scalar_space());
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
        write_texts(object, name, value, vector_space(value.size()));
    } else {
        write_numbers(object, name, number_type<typename T::value_type>(), vector_space(value.size()), value.data());
    }
}

/// Reads an attribute. \return false if its type or size does not fit
bool read_attribute(hid_t attribute, std::vector<std::string>& out);
template <class T>
bool read_attribute(hid_t attribute, std::vector<T>& out) {
    const H5T_class_t kind = H5Tget_class(type_of_attribute(attribute).get());
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) return false;
    out.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space_of_attribute(attribute).get())));
    return out.empty() || H5Aread(attribute, number_type<T>(), out.data()) >= 0;
}
template <class T>
bool read_attribute(hid_t attribute, T& out) {
    std::vector<T> values;
    if (!read_attribute(attribute, values) || values.size() != 1) return false;
    out = values[0];
    return true;
}

/// A link of a group. Files of this project have hard links only.
struct Link {
    std::string name;
    bool is_hard;
};
/// Reads the links of a group, sorted by name. \return false if they cannot be read
bool links_of(hid_t file, const std::string& group, std::vector<Link>& links);
/// Names of the links in a group, sorted.
std::vector<std::string> link_names(hid_t file, const std::string& group);

std::string type_name(hid_t type);
Extents space_extents(hid_t space);
std::string extents_text(const Extents& extents);

// --- opening and checking ---------------------------------------------------------------------------------------------

/// Returns all bytes of stdin. \throws InputError if they cannot be read
std::vector<char> read_stdin();

/// Opens a file image. \param name in messages \throws InputError if it is empty or cannot be opened
Handle open_image(std::span<const char> bytes, const std::string& name);
/// Opens a file. \throws InputError if it does not exist or cannot be opened
Handle open_path(const std::string& path);

/// Visits all groups. \throws InputError for links other than hard ones, for a group that is linked more than once (as in a
/// cycle), and for groups nested deeper than this project's
void require_tree(hid_t file, const std::string& file_name);

/// Number of values of a dataset. \throws InputError, before any value is read, unless they are numbers in this file with filters
/// that this project uses, and no more than its bytes can hold
std::size_t require_readable(hid_t dataset, const std::string& file_name, const std::string& path);

/// Checks an attribute. \throws InputError if it declares more bytes than the file has, or texts of variable length: the library
/// stores those separately, where a damaged file misleads it
void require_readable_attribute(hid_t attribute, const std::string& file_name, const std::string& object,
                                const std::string& name);

// --- digest and list of the content -----------------------------------------------------------------------------------

/// SHA-256 (hex) over every path, type, shape, attribute and value below the root, except the object `left_out`.
/// \throws InputError for the first object that cannot be read
std::string digest(hid_t file, const std::string& file_name, const std::string& left_out);

/// Returns one line per dataset: path, type, shape, unit, description.
std::vector<std::string> describe(hid_t file, const std::string& file_name);

}  // namespace graincrack::h5
