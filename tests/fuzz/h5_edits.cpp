#include "tests/fuzz/h5_edits.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <limits>
#include <vector>

namespace graincrack::fuzz {
namespace {

/// A dataset, or an attribute of an object.
struct Place {
    std::string object;
    std::string attribute;  ///< "" for a dataset
};

herr_t add_attribute(hid_t, const char* name, const H5A_info_t*, void* data) {
    auto& [places, object] = *static_cast<std::pair<std::vector<Place>*, std::string>*>(data);
    places->push_back({object, name});
    return 0;
}

herr_t add_object(hid_t file, const char* name, const H5O_info_t* info, void* data) {
    auto* places = static_cast<std::vector<Place>*>(data);
    if (info->type == H5O_TYPE_DATASET) places->push_back({name, ""});
    std::pair<std::vector<Place>*, std::string> of_object{places, name};
    const hid_t object = H5Oopen(file, name, H5P_DEFAULT);
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add_attribute, &of_object);
    H5Oclose(object);
    return 0;
}

std::vector<Place> places_of(hid_t file) {
    std::vector<Place> places;
    H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, add_object, &places);
    return places;
}

/// Values that readers may not expect, or any.
double value_of(const std::uint8_t* bytes) {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr std::array<double, 16> special{0,
                                             -1,
                                             1,
                                             2,
                                             0.5,
                                             1e-300,
                                             1e300,
                                             std::numeric_limits<double>::infinity(),
                                             -1e9,
                                             2147483647,
                                             -2147483648.0,
                                             4294967296.0,
                                             9.3e18,
                                             -largest,
                                             255,
                                             std::numeric_limits<double>::quiet_NaN()};
    if (bytes[0] < 192) return special[bytes[0] % special.size()];
    double value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// Extents of a place changed: of the first one more, one less, none, many; or another rank.
std::vector<hsize_t> other_extents(std::vector<hsize_t> extents, std::uint8_t how) {
    if (extents.empty()) extents.push_back(1);
    switch (how % 6) {
        case 0: ++extents[0]; break;
        case 1: extents[0] -= std::min<hsize_t>(extents[0], 1); break;
        case 2: extents[0] = 0; break;
        case 3: extents.push_back(2); break;
        case 4: extents = {extents[0]}; break;
        default: extents.clear();
    }
    return extents;
}

/// Type and extents of a dataset or attribute.
struct Shape {
    hid_t type;
    std::vector<hsize_t> extents;
};
Shape shape_of(hid_t type, hid_t space) {
    Shape shape{type, std::vector<hsize_t>(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))))};
    H5Sget_simple_extent_dims(space, shape.extents.data(), nullptr);
    H5Sclose(space);
    return shape;
}
std::size_t count_of(const std::vector<hsize_t>& extents) {
    std::size_t count = 1;
    for (const hsize_t extent : extents) count *= extent;
    return count;
}
hid_t space_of(const std::vector<hsize_t>& extents) {
    return extents.empty() ? H5Screate(H5S_SCALAR) : H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
}

hid_t type_of(std::uint8_t how, hid_t own) {
    switch (how % 5) {
        case 0: return H5Tcopy(H5T_STD_I64LE);
        case 1: return H5Tcopy(H5T_IEEE_F32LE);
        case 2: return H5Tcopy(H5T_STD_U8LE);
        case 3: return H5Tcopy(H5T_C_S1);
        default: return H5Tcopy(own);
    }
}

/// Writes numbers where the type takes them; what is text stays empty.
template <class Write>
void write_numbers(hid_t type, const std::vector<double>& values, const Write& write) {
    const H5T_class_t kind = H5Tget_class(type);
    if (!values.empty() && (kind == H5T_INTEGER || kind == H5T_FLOAT)) write(values.data());
}

void edit_dataset(hid_t file, const std::string& name, const std::uint8_t* edit) {
    const hid_t dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
    Shape shape = shape_of(H5Dget_type(dataset), H5Dget_space(dataset));
    const std::uint8_t kind = edit[2] % 5;
    std::vector<double> values(count_of(shape.extents));
    const bool is_number = H5Tget_class(shape.type) == H5T_INTEGER || H5Tget_class(shape.type) == H5T_FLOAT;
    if (is_number && !values.empty()) H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    if (kind == 0 && !values.empty()) {  // one value
        values[(edit[3] * 257U + edit[11]) % values.size()] = value_of(edit + 4);
    } else if (kind == 1) {  // all values
        std::fill(values.begin(), values.end(), value_of(edit + 4));
    }
    if (kind <= 1) {
        write_numbers(shape.type, values,
                      [&](const double* v) { H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, v); });
        H5Dclose(dataset);
        H5Tclose(shape.type);
        return;
    }
    H5Dclose(dataset);
    H5Ldelete(file, name.c_str(), H5P_DEFAULT);
    if (kind != 2) {  // another shape or type; else it is missing
        const std::vector<hsize_t> extents = kind == 3 ? other_extents(shape.extents, edit[3]) : shape.extents;
        values.resize(count_of(extents), 1);
        const hid_t type = kind == 3 ? H5Tcopy(shape.type) : type_of(edit[3], shape.type);
        const hid_t space = space_of(extents);
        const hid_t again = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        if (again >= 0) {
            write_numbers(type, values,
                          [&](const double* v) { H5Dwrite(again, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, v); });
            H5Dclose(again);
        }
        H5Sclose(space);
        H5Tclose(type);
    }
    H5Tclose(shape.type);
}

void edit_attribute(hid_t file, const Place& place, const std::uint8_t* edit) {
    const hid_t attribute = H5Aopen_by_name(file, place.object.c_str(), place.attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    Shape shape = shape_of(H5Aget_type(attribute), H5Aget_space(attribute));
    const std::uint8_t kind = edit[2] % 5;
    if (kind <= 1) {
        std::vector<double> values(count_of(shape.extents), value_of(edit + 4));
        write_numbers(shape.type, values, [&](const double* v) { H5Awrite(attribute, H5T_NATIVE_DOUBLE, v); });
        if (H5Tget_class(shape.type) == H5T_STRING && H5Tis_variable_str(shape.type) == 0) {
            std::vector<char> text(H5Tget_size(shape.type) * std::max<std::size_t>(1, values.size()), static_cast<char>(edit[4]));
            H5Awrite(attribute, shape.type, text.data());
        }
        H5Aclose(attribute);
        H5Tclose(shape.type);
        return;
    }
    H5Aclose(attribute);
    H5Adelete_by_name(file, place.object.c_str(), place.attribute.c_str(), H5P_DEFAULT);
    if (kind != 2) {
        const std::vector<hsize_t> extents = kind == 3 ? other_extents(shape.extents, edit[3]) : shape.extents;
        const hid_t type = kind == 3 ? H5Tcopy(shape.type) : type_of(edit[3], shape.type);
        const hid_t space = space_of(extents);
        const hid_t again = H5Acreate_by_name(file, place.object.c_str(), place.attribute.c_str(), type, space, H5P_DEFAULT,
                                              H5P_DEFAULT, H5P_DEFAULT);
        if (again >= 0) {
            const std::vector<double> values(count_of(extents), value_of(edit + 4));
            write_numbers(type, values, [&](const double* v) { H5Awrite(again, H5T_NATIVE_DOUBLE, v); });
            H5Aclose(again);
        }
        H5Sclose(space);
        H5Tclose(type);
    }
    H5Tclose(shape.type);
}

}  // namespace

void write_damaged(const std::string& base, const std::uint8_t* bytes, std::size_t size, const std::string& damaged) {
    std::filesystem::copy_file(base, damaged, std::filesystem::copy_options::overwrite_existing);
    const hid_t file = H5Fopen(damaged.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    constexpr std::size_t bytes_of_edit = 12;
    constexpr std::size_t max_edits = 4;
    for (std::size_t i = 0; i < std::min(size / bytes_of_edit, max_edits); ++i) {
        const std::uint8_t* const edit = bytes + i * bytes_of_edit;
        const std::vector<Place> places = places_of(file);
        const Place& place = places[(edit[0] + 256U * edit[1]) % places.size()];
        if (place.attribute.empty()) {
            edit_dataset(file, place.object, edit);
        } else {
            edit_attribute(file, place, edit);
        }
    }
    H5Fclose(file);
}

}  // namespace graincrack::fuzz
