#include "share/h5_digest.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include "share/error.hpp"
#include "share/h5_detail.hpp"

namespace graincrack::h5 {
namespace {

/// SHA-256 by OpenSSL.
class Sha256 {
public:
    Sha256() : context_(EVP_MD_CTX_new()) { EVP_DigestInit_ex(context_, EVP_sha256(), nullptr); }
    ~Sha256() { EVP_MD_CTX_free(context_); }
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;
    void add(const void* data, std::size_t size) { EVP_DigestUpdate(context_, data, size); }
    void add(const std::string& text) { add(text.c_str(), text.size() + 1); }
    std::string hex() {
        unsigned char bytes[EVP_MAX_MD_SIZE];
        unsigned size = 0;
        EVP_DigestFinal_ex(context_, bytes, &size);
        std::string text;
        for (unsigned i = 0; i < size; ++i) {
            text += fmt::format("{:02x}", bytes[i]);
        }
        return text;
    }

private:
    EVP_MD_CTX* context_;
};

/// Type in memory in which values are hashed: the same on every machine.
hid_t hash_type(hid_t type) {
    switch (H5Tget_class(type)) {
        case H5T_INTEGER: return H5Tget_size(type) == 1 ? H5T_STD_U8LE : H5T_STD_I64LE;
        case H5T_FLOAT: return H5T_IEEE_F64LE;
        default: return -1;
    }
}

void digest_attributes(hid_t object, Sha256& hash) {
    for (const std::string& name : attribute_names(object)) {
        const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
        const Handle type(H5Aget_type(attribute.get()), H5Tclose);
        const Handle space(H5Aget_space(attribute.get()), H5Sclose);
        hash.add("@" + name + " " + type_name(type.get()) + " " + extents_text(space_extents(space.get())));
        std::vector<std::string> texts;
        if (read_attribute(attribute.get(), texts)) {
            for (const std::string& text : texts) {
                hash.add(text);
            }
        } else if (const hid_t as = hash_type(type.get()); as >= 0) {
            std::vector<char> bytes(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())) * H5Tget_size(as));
            H5Aread(attribute.get(), as, bytes.data());
            hash.add(bytes.data(), bytes.size());
        }
    }
}

void digest_object(hid_t file, const std::string& path, const std::string& file_name, const std::string& left_out, Sha256& hash) {
    const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object.valid()) {
        throw InputError(fmt::format("{}: {} cannot be read", file_name, path));
    }
    if (H5Iget_type(object.get()) == H5I_GROUP) {
        hash.add(path + " group");
        digest_attributes(object.get(), hash);
        for (const std::string& name : link_names(file, path)) {
            const std::string child = (path == "/" ? "" : path) + "/" + name;
            if (child != left_out) {
                digest_object(file, child, file_name, left_out, hash);
            }
        }
        return;
    }
    const Handle type(H5Dget_type(object.get()), H5Tclose);
    const Handle space(H5Dget_space(object.get()), H5Sclose);
    hash.add(path + " " + type_name(type.get()) + " " + extents_text(space_extents(space.get())));
    digest_attributes(object.get(), hash);
    const hid_t as = hash_type(type.get());
    const auto n = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
    if (as < 0 || n == 0) {
        return;
    }
    std::vector<char> bytes(n * H5Tget_size(as));
    if (H5Dread(object.get(), as, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) {
        throw InputError(fmt::format("{}: {} cannot be read: the file is damaged", file_name, path));
    }
    hash.add(bytes.data(), bytes.size());
}

void describe_object(hid_t file, const std::string& path, std::vector<std::string>& lines) {
    const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose);
    if (H5Iget_type(object.get()) == H5I_GROUP) {
        for (const std::string& name : link_names(file, path)) {
            describe_object(file, (path == "/" ? "" : path) + "/" + name, lines);
        }
        return;
    }
    const Handle type(H5Dget_type(object.get()), H5Tclose);
    const Handle space(H5Dget_space(object.get()), H5Sclose);
    std::string line = fmt::format("{} {} {}", path, type_name(type.get()), extents_text(space_extents(space.get())));
    for (const char* name : {"unit", "description"}) {
        std::string text;
        const Handle attribute(H5Aexists(object.get(), name) > 0 ? H5Aopen(object.get(), name, H5P_DEFAULT) : -1, H5Aclose);
        if (attribute.valid() && read_attribute(attribute.get(), text)) {
            line += " " + text;
        }
    }
    lines.push_back(line);
}

}  // namespace

std::string digest(hid_t file, const std::string& file_name, const std::string& left_out) {
    Sha256 hash;
    digest_object(file, "/", file_name, left_out, hash);
    return hash.hex();
}

std::vector<std::string> describe(hid_t file) {
    std::vector<std::string> lines;
    describe_object(file, "/", lines);
    return lines;
}

}  // namespace graincrack::h5
