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

}  // namespace graincrack::h5
