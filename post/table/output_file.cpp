#include "post/table/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "share/error.hpp"

namespace graincrack {

namespace {

[[noreturn]] void refuse(const std::string& path, int cause) {
    throw OutputError(path + ": cannot be written: " + std::generic_category().message(cause));
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), part_(path_ + ".part") {
    if (std::filesystem::is_directory(path_)) refuse(path_, EISDIR);
    const int file = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) refuse(path_, errno);
    ::close(file);
}

OutputFile::~OutputFile() {
    if (!committed_) ::unlink(part_.c_str());
}

void OutputFile::commit() {
    const int file = ::open(part_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) refuse(path_, errno);
    const int failed = ::fsync(file) == 0 ? 0 : errno;
    ::close(file);
    if (failed != 0) refuse(path_, failed);
    if (std::rename(part_.c_str(), path_.c_str()) != 0) refuse(path_, errno);
    committed_ = true;
}

void write_whole_file(const std::string& path, std::string_view content) {
    OutputFile file(path);
    std::FILE* stream = std::fopen(file.part().c_str(), "wb");
    if (stream == nullptr) refuse(path, errno);
    const bool written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
    const int cause = errno;
    if (std::fclose(stream) != 0 || !written) refuse(path, written ? errno : cause);
    file.commit();
}

void make_folder(const std::string& path) {
    std::error_code cause;
    std::filesystem::create_directories(path, cause);
    if (cause) refuse(path, cause.value());
}

}  // namespace graincrack
