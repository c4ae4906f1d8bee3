// Internals of reading and writing HDF5: identifiers that close themselves, types, attributes. Included by share/h5_*.cpp only.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
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
    /// Whether it could be closed.
    bool reset() {
        const hid_t id = std::exchange(id_, -1);
        return id < 0 || close_(id) >= 0;
    }

private:
    hid_t id_ = -1;
    herr_t (*close_)(hid_t) = nullptr;
};

inline Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

/// HDF5 type of a C++ type in memory, and in files (little endian on every machine).
template <class T>
hid_t memory_type();
template <>
inline hid_t memory_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t memory_type<float>() {
    return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t memory_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
inline hid_t memory_type<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
inline hid_t memory_type<std::uint8_t>() {
    return H5T_NATIVE_UINT8;
}

template <class T>
hid_t file_type();
template <>
inline hid_t file_type<double>() {
    return H5T_IEEE_F64LE;
}
template <>
inline hid_t file_type<std::int32_t>() {
    return H5T_STD_I32LE;
}
template <>
inline hid_t file_type<std::int64_t>() {
    return H5T_STD_I64LE;
}
template <>
inline hid_t file_type<std::uint8_t>() {
    return H5T_STD_U8LE;
}

Handle scalar_space();
Handle vector_space(std::size_t n);

/// Writes or replaces an attribute. Texts are of fixed length, as VTK's readers expect them of /VTKHDF.
void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, std::int64_t value);
void write_attribute(hid_t object, const std::string& name, const std::string& value);
void write_attribute(hid_t object, const std::string& name, const std::vector<double>& values);
void write_attribute(hid_t object, const std::string& name, const std::vector<std::int64_t>& values);
void write_attribute(hid_t object, const std::string& name, const std::vector<std::string>& values);

/// Reads an attribute; false if its type or size does not fit.
bool read_attribute(hid_t attribute, double& out);
bool read_attribute(hid_t attribute, std::int64_t& out);
bool read_attribute(hid_t attribute, std::string& out);
bool read_attribute(hid_t attribute, std::vector<double>& out);
bool read_attribute(hid_t attribute, std::vector<std::int64_t>& out);
bool read_attribute(hid_t attribute, std::vector<std::string>& out);

/// Names of the links in a group, sorted.
std::vector<std::string> link_names(hid_t file, const std::string& group);
/// Names of the attributes of an object, sorted; false if one of them is damaged.
bool attribute_names(hid_t object, std::vector<std::string>& names);

std::string type_name(hid_t type);
Extents space_extents(hid_t space);
std::string extents_text(const Extents& extents);

/// One line for each dataset: path, type, shape, unit, description.
std::vector<std::string> describe(hid_t file, const std::string& file_name);

}  // namespace graincrack::h5
