#include "share/file/h5_open.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "share/base/error.hpp"

namespace graincrack::h5 {

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
Handle open_image(const std::vector<char>& bytes) {
    if (bytes.empty()) throw InputError("stdin: empty: the program before wrote nothing; see its message");
    const Handle access = property_list(H5P_FILE_ACCESS);
    H5Pset_fapl_core(access.get(), 1 << 20, 0);
    H5Pset_file_image(access.get(), const_cast<char*>(bytes.data()),
                      bytes.size());  // NOLINT: the C interface takes it non-const, and copies
    return {H5Fopen("graincrack-stdin", H5F_ACC_RDONLY, access.get()), H5Fclose};
}

Handle open_path(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) {
        throw InputError(fmt::format("{}: {}", path, errno == ENOENT ? "no such file" : std::strerror(errno)));
    }
    if (S_ISDIR(status.st_mode)) throw InputError(fmt::format("{}: is a folder, an HDF5 file is needed", path));
    if (::access(path.c_str(), R_OK) != 0) throw InputError(fmt::format("{}: {}", path, std::strerror(errno)));
    if (status.st_size == 0) throw InputError(fmt::format("{}: empty file, a file written by a Graincrack tool is needed", path));
    return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
}

void throw_unreadable(const std::string& name, bool has_signature) {
    if (has_signature) {
        throw InputError(fmt::format("{}: truncated or damaged HDF5 file; write it again with the tool that made it", name));
    }
    throw InputError(fmt::format("{}: not an HDF5 file; a file written by a Graincrack tool is needed", name));
}

bool has_hdf5_signature(const char* bytes, std::size_t size) {
    static constexpr unsigned char signature[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    return size >= 8 && std::memcmp(bytes, signature, 8) == 0;
}

bool file_has_hdf5_signature(const std::string& path) {
    char head[8] = {};
    const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) return false;
    const ssize_t n = ::read(fd, head, sizeof head);
    ::close(fd);
    return has_hdf5_signature(head, n > 0 ? static_cast<std::size_t>(n) : 0);
}

}  // namespace graincrack::h5
