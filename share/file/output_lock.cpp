#include "share/file/output_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

/// Whether an open file is the one that has a path now: the program that held it before may have removed it.
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

}  // namespace graincrack
