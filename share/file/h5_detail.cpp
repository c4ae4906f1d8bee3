#include "share/file/h5_detail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "share/base/error.hpp"

namespace graincrack::h5 {

namespace {

Handle fixed_string_type(std::size_t size) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    return type;
}

void replace_attribute(hid_t object, const std::string& name, hid_t type, hid_t space, const void* data) {
    if (H5Aexists(object, name.c_str()) > 0) H5Adelete(object, name.c_str());
    const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const bool is_empty = H5Sget_simple_extent_npoints(space) == 0;  // HDF5 cannot write an empty list of texts
    if (!attribute.valid() || (!is_empty && H5Awrite(attribute.get(), type, data) < 0)) {
        throw OutputError(fmt::format("attribute {} cannot be written", name));
    }
}

}  // namespace

Handle scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose}; }
Handle vector_space(std::size_t n) {
    const hsize_t extent = n;
    return {H5Screate_simple(1, &extent, nullptr), H5Sclose};
}

void write_attribute(hid_t object, const std::string& name, double value) {
    replace_attribute(object, name, H5T_IEEE_F64LE, scalar_space().get(), &value);
}
void write_attribute(hid_t object, const std::string& name, std::int64_t value) {
    replace_attribute(object, name, H5T_STD_I64LE, scalar_space().get(), &value);
}
// Fixed-length ASCII/UTF-8 text: what VTK's readers expect of /VTKHDF and everybody else reads too.
void write_attribute(hid_t object, const std::string& name, const std::string& value) {
    const Handle type = fixed_string_type(value.size());
    const std::string padded = value.empty() ? std::string(1, '\0') : value;
    replace_attribute(object, name, type.get(), scalar_space().get(), padded.data());
}
void write_attribute(hid_t object, const std::string& name, const std::vector<double>& values) {
    replace_attribute(object, name, H5T_IEEE_F64LE, vector_space(values.size()).get(), values.data());
}
void write_attribute(hid_t object, const std::string& name, const std::vector<std::int64_t>& values) {
    replace_attribute(object, name, H5T_STD_I64LE, vector_space(values.size()).get(), values.data());
}
void write_attribute(hid_t object, const std::string& name, const std::vector<std::string>& values) {
    std::size_t size = 1;
    for (const std::string& value : values) size = std::max(size, value.size());
    std::string padded;
    for (const std::string& value : values) padded += value + std::string(size - value.size(), '\0');
    replace_attribute(object, name, fixed_string_type(size).get(), vector_space(values.size()).get(), padded.data());
}

namespace {

/// Reads a string attribute of fixed length, scalar or vector.
bool read_strings(hid_t attribute, std::vector<std::string>& out) {
    const Handle type(H5Aget_type(attribute), H5Tclose);
    const Handle space(H5Aget_space(attribute), H5Sclose);
    if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) > 0) return false;
    const auto n = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
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

template <class T>
bool read_numbers(hid_t attribute, std::vector<T>& out) {
    const Handle type(H5Aget_type(attribute), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type.get());
    if (kind != H5T_INTEGER && kind != H5T_FLOAT) return false;
    const Handle space(H5Aget_space(attribute), H5Sclose);
    out.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())));
    return out.empty() || H5Aread(attribute, memory_type<T>(), out.data()) >= 0;
}

}  // namespace

bool read_attribute(hid_t attribute, double& out) {
    std::vector<double> values;
    const bool read = read_numbers(attribute, values) && values.size() == 1;
    out = read ? values[0] : 0;
    return read;
}
bool read_attribute(hid_t attribute, std::int64_t& out) {
    std::vector<std::int64_t> values;
    const bool read = read_numbers(attribute, values) && values.size() == 1;
    out = read ? values[0] : 0;
    return read;
}
bool read_attribute(hid_t attribute, std::string& out) {
    std::vector<std::string> values;
    const bool read = read_strings(attribute, values) && values.size() == 1;
    out = read ? values[0] : "";
    return read;
}
bool read_attribute(hid_t attribute, std::vector<double>& out) { return read_numbers(attribute, out); }
bool read_attribute(hid_t attribute, std::vector<std::int64_t>& out) { return read_numbers(attribute, out); }
bool read_attribute(hid_t attribute, std::vector<std::string>& out) { return read_strings(attribute, out); }

namespace {

herr_t collect_name(hid_t /*group*/, const char* name, const H5L_info_t* /*info*/, void* data) {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
}
herr_t collect_attribute(hid_t /*object*/, const char* name, const H5A_info_t* /*info*/, void* data) {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
}

}  // namespace

std::vector<std::string> link_names(hid_t object, const std::string& group) {
    std::vector<std::string> names;
    hsize_t start = 0;
    const Handle id(H5Gopen2(object, group.c_str(), H5P_DEFAULT), H5Gclose);
    if (id.valid()) H5Literate(id.get(), H5_INDEX_NAME, H5_ITER_INC, &start, collect_name, &names);
    std::sort(names.begin(), names.end());
    return names;
}

// The iteration frees its table twice where an attribute cannot be decoded (HDF5 1.10.8). Looking up a name that there is not
// decodes all attributes, and fails where one cannot be.
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

}  // namespace graincrack::h5
