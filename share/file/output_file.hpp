// Writes outputs. Files appear completely or not at all: they are written as NAME.part, synced and renamed.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace graincrack {

/// True if an output receives bytes immediately: "-", which is stdout, and an existing object that is neither a file nor a
/// folder, such as a device, a named pipe or /dev/stdout. It is never replaced or removed.
bool is_stream(const std::string& output);

/// Holds a lock on the file `output`.lock and removes the file at the end. The system releases the lock of a program that has
/// died; a leftover file is harmless. If the file cannot be made or locked, as on a file system without locks, there is no lock.
class OutputLock {
public:
    /// Takes the lock. \throws OutputError if another program holds it, or its name is that of a symbolic link
    explicit OutputLock(const std::string& output);
    ~OutputLock();
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

private:
    std::string path_;
    int file_ = -1;
};

/// An output of the user. A file is written to the path that `begin` returns, and gets its name by `commit`; without a commit
/// nothing is left. Its lock excludes other programs. A symbolic link to a file stays, and its target is written.
class OutputFile {
public:
    /// Takes the lock and changes nothing else. \param ending longest ending of the names of temporary files
    /// \throws UsageError for a block device, and for the names of unfinished files (.part, .lock, .checkpoint); OutputError for
    /// a folder, without a folder, for a name that is too long, for a file that nobody may write, or if another program writes it
    explicit OutputFile(const std::string& output, std::string_view ending = ".part");
    /// A file at `path` that belongs to another output, whose lock covers it.
    static std::unique_ptr<OutputFile> covered(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] const std::string& name() const { return name_; }  ///< for messages; "stdout" for "-"
    [[nodiscard]] bool is_stream() const { return path_.empty(); }
    [[nodiscard]] bool is_covered() const { return !is_stream() && !lock_; }
    [[nodiscard]] bool is_terminal() const;
    /// The existing, non-empty file that `commit` replaces; "" if there is none.
    [[nodiscard]] std::string replaced() const;

    /// Creates the empty unfinished file. \return its path \throws OutputError
    const std::string& begin();
    /// Writes into the stream or the unfinished file. \throws OutputError
    void write(std::string_view bytes);
    /// Syncs and renames the file. \throws OutputError
    void commit();

private:
    OutputFile() = default;
    void take_mode();
    void open_stream(const std::string& path);

    std::string name_;
    std::string path_;  ///< path of the file; "" for a stream
    std::string part_;
    std::unique_ptr<OutputLock> lock_;
    std::optional<unsigned> mode_ = {};  ///< mode of the replaced file
    int file_ = -1;                      ///< the stream, or the unfinished file
};

/// Checks that an output replaces no file of another kind. \throws UsageError for an HDF5 file
void require_no_hdf5(const OutputFile& file);

/// Writes a text or a picture. \throws UsageError if it would replace an HDF5 file; OutputError if it cannot be written
void write_whole_file(const std::string& output, std::string_view content);

/// Checks the name of an output file. \throws UsageError unless it ends in `ending`
void require_ending(const std::string& output, const std::string& ending);

/// Removes a file or a symbolic link, if there is one; other objects stay. \throws OutputError
void remove_file(const std::string& path);

/// Makes a folder and its parents. \throws OutputError
void make_folder(const std::string& path);

}  // namespace graincrack
