#include "share/file/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/events.hpp"

namespace graincrack {

namespace fs = std::filesystem;

namespace {

constexpr int most_links = 40;  // links in a chain, as in the kernel
constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";

[[noreturn]] void refuse(const std::string& name, int cause) {
    throw OutputError(name + ": cannot be written: " + std::generic_category().message(cause));
}

/// Follows symbolic links to a path; none if they lead to an open file of a process, as /dev/stdout does.
std::optional<fs::path> target_of(const std::string& name) {
    fs::path path = name;
    for (int link = 0; link < most_links; ++link) {
        std::error_code missing;
        const fs::path folder = fs::canonical(path.has_parent_path() ? path.parent_path() : ".", missing);
        if (!missing && folder.string().starts_with("/proc/")) return std::nullopt;
        if (fs::symlink_status(path, missing).type() != fs::file_type::symlink) return path;
        path = path.parent_path() / fs::read_symlink(path);
    }
    refuse(name, ELOOP);
}

fs::file_type type_of(const fs::path& path) {
    std::error_code missing;
    return fs::status(path, missing).type();
}

bool is_stream_type(fs::file_type type) {
    return type != fs::file_type::not_found && type != fs::file_type::none && type != fs::file_type::unknown &&
           type != fs::file_type::regular && type != fs::file_type::directory;
}

void require_free_name(const std::string& output) {
    for (const char* ending : {".part", ".lock", ".checkpoint"}) {
        if (output.ends_with(ending)) {
            throw UsageError(
                fmt::format("{}: names in {} are those of unfinished outputs; give it another name", output, ending));
        }
    }
}

/// Checks the length of a name with its ending. \throws OutputError if it is too long for the file system
void require_short_name(const std::string& name, const fs::path& path, std::string_view ending) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const long room = ::pathconf(folder.c_str(), _PC_NAME_MAX) - static_cast<long>(ending.size());
    const std::size_t length = path.filename().string().size();
    if (room > 0 && static_cast<long>(length) > room) {
        throw OutputError(fmt::format("{}: its name has {} bytes; {} fit, and {} behind it", name, length, room, ending));
    }
}

/// True if an open file still has this path: the program that held it before may have removed it.
bool is_at(const std::string& path, int file) {
    struct stat own {};
    struct stat there {};
    return ::fstat(file, &own) == 0 && ::stat(path.c_str(), &there) == 0 && own.st_ino == there.st_ino &&
           own.st_dev == there.st_dev;
}

}  // namespace

OutputLock::OutputLock(const std::string& output) : path_(output + ".lock") {
    do {
        if (file_ >= 0) ::close(file_);
        file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (file_ < 0 && errno == ELOOP) throw OutputError(path_ + ": is a symbolic link, and no lock of ours; remove it");
        if (file_ < 0) return;
        if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
            const bool is_held = errno == EWOULDBLOCK;
            ::close(file_);
            file_ = -1;
            if (is_held) throw OutputError(output + ": is being written by another program; wait for it, or name another output");
            return;
        }
    } while (!is_at(path_, file_));
}

OutputLock::~OutputLock() {
    if (file_ >= 0) {
        ::unlink(path_.c_str());
        ::close(file_);
    }
}

bool is_stream(const std::string& output) {
    if (output == "-") return true;
    const std::optional<fs::path> target = target_of(output);
    return !target || is_stream_type(type_of(*target));
}

OutputFile::OutputFile(const std::string& output, std::string_view ending) : name_(output == "-" ? "stdout" : output) {
    if (graincrack::is_stream(output)) {
        open_stream(output);
        return;
    }
    require_free_name(output);
    const fs::path target = *target_of(output);
    const fs::path folder = target.parent_path();
    if (type_of(target) == fs::file_type::directory) throw OutputError(name_ + ": is a folder, name a file in it");
    if (!folder.empty() && type_of(folder) != fs::file_type::directory) {
        throw OutputError(fmt::format("{}: the folder {} does not exist", name_, folder.string()));
    }
    path_ = target.string();
    part_ = path_ + ".part";
    require_short_name(name_, target, ending);
    take_mode();
    lock_ = std::make_unique<OutputLock>(path_);
    hold_output(path_);
}

std::unique_ptr<OutputFile> OutputFile::covered(const std::string& path) {
    std::unique_ptr<OutputFile> file(new OutputFile);
    file->name_ = file->path_ = path;
    file->part_ = path + ".part";
    return file;
}

void OutputFile::take_mode() {
    struct stat status {};
    if (::stat(path_.c_str(), &status) != 0) return;
    mode_ = status.st_mode & 07777U;
    const bool is_protected = (*mode_ & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0;  // root may write it nevertheless
    if (is_protected || ::access(path_.c_str(), W_OK) != 0) {
        throw OutputError(name_ + ": is write-protected; give another name, or allow writing it (chmod u+w)");
    }
}

OutputFile::~OutputFile() {
    hold_output("");
    if (!is_stream() && file_ >= 0) ::unlink(part_.c_str());
    if (file_ > STDERR_FILENO) ::close(file_);
}

void OutputFile::open_stream(const std::string& path) {
    if (path == "-") {
        file_ = STDOUT_FILENO;
        return;
    }
    if (type_of(path) == fs::file_type::block) throw UsageError(path + ": is a disk; name a file");
    file_ = ::open(path.c_str(), O_WRONLY | O_APPEND | O_NOCTTY | O_CLOEXEC);
    if (file_ < 0) refuse(name_, errno);
}

bool OutputFile::is_terminal() const { return is_stream() && ::isatty(file_) != 0; }

std::string OutputFile::replaced() const {
    std::error_code none;
    return !path_.empty() && fs::file_size(path_, none) > 0 && !none ? path_ : "";
}

const std::string& OutputFile::begin() {
    remove_file(part_);  // left by a program that was killed
    file_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode_ ? *mode_ | S_IRUSR | S_IWUSR : 0666);
    if (file_ < 0) refuse(name_, errno);
    return part_;
}

void OutputFile::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(file_, bytes.data(), bytes.size());
        if (n >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(n));
        } else if (errno != EINTR) {
            refuse(name_, errno);
        }
    }
}

void OutputFile::commit() {
    if (is_stream()) return;
    if (mode_) ::fchmod(file_, *mode_);  // file systems without modes ignore this
    if (::fsync(file_) != 0 || std::rename(part_.c_str(), path_.c_str()) != 0) refuse(name_, errno);
    ::close(std::exchange(file_, -1));
    if (!is_covered()) add_output_to_outcome(name_);
}

void require_no_hdf5(const OutputFile& file) {
    std::string head(hdf5_signature.size(), '\0');
    std::ifstream(file.replaced(), std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
    if (head == hdf5_signature) throw UsageError(file.name() + ": is a run, a specimen or another HDF5 file; give another name");
}

void write_whole_file(const std::string& output, std::string_view content) {
    OutputFile file(output);
    if (!file.is_stream()) {
        require_no_hdf5(file);
        file.begin();
    }
    file.write(content);
    file.commit();
}

void require_ending(const std::string& output, const std::string& ending) {
    if (!is_stream(output) && !output.ends_with(ending)) {
        throw UsageError(fmt::format("--output {}: its name must end in {}", output, ending));
    }
}

void remove_file(const std::string& path) {
    std::error_code cause;
    const fs::file_type type = fs::symlink_status(path, cause).type();
    if (type != fs::file_type::regular && type != fs::file_type::symlink) return;
    fs::remove(path, cause);
    if (cause) throw OutputError(path + ": cannot be removed: " + cause.message());
}

void make_folder(const std::string& path) {
    std::error_code cause;
    fs::create_directories(path, cause);
    if (cause) refuse(path, cause.value());
}

}  // namespace graincrack
