// Outputs: where they go, and that files appear whole or not at all: written as NAME.part, synced, renamed.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace graincrack {

/// Whether bytes are written into an output as they come: "-", which is stdout, and what exists and is neither a file nor a
/// folder, such as a device, a named pipe or /dev/stdout. It is never replaced or removed.
bool is_stream(const std::string& output);

/// Holds the file `output`.lock while it lives, then removes it. The system releases the lock of a program that has died; what is
/// left of its file does not matter. Where the file cannot be made or locked, as on a file system without locks, there is none.
class OutputLock {
public:
    /// \throws OutputError if another program holds it, or its name is that of a symbolic link
    explicit OutputLock(const std::string& output);
    ~OutputLock();
    OutputLock(const OutputLock&) = delete;
    OutputLock& operator=(const OutputLock&) = delete;

private:
    std::string path_;
    int file_ = -1;
};

/// An output of the user's. A file is written at the path that `begin` gives, and has its name from `commit` on; without a commit
/// nothing is left. Its lock keeps other programs away. A symbolic link to a file stays, and the file it leads to is written.
class OutputFile {
public:
    /// Takes the lock, and changes nothing yet. \param ending the longest behind its name of what is written beside it
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
    /// The file, not empty, that `commit` replaces; "" if there is none.
    [[nodiscard]] std::string replaced() const;

    /// Makes the unfinished file, empty. \return its path \throws OutputError
    const std::string& begin();
    /// Writes into a stream, or the unfinished file. \throws OutputError
    void write(std::string_view bytes);
    /// Syncs and renames a file. \throws OutputError
    void commit();

private:
    OutputFile() = default;
    void take_mode();
    void open_stream(const std::string& path);

    std::string name_;
    std::string path_;  ///< of the file; "" for a stream
    std::string part_;
    std::unique_ptr<OutputLock> lock_;
    std::optional<unsigned> mode_ = {};  ///< of the file that is replaced
    int file_ = -1;                      ///< the stream, or the unfinished file
};

/// Checks what an output of another kind would replace. \throws UsageError for an HDF5 file
void require_no_hdf5(const OutputFile& file);

/// Writes a text or a picture. \throws UsageError if a file of another kind, an HDF5 file, would be replaced; OutputError
void write_whole_file(const std::string& output, std::string_view content);

/// Checks the name of an output that is a file. \throws UsageError unless it ends in `ending`
void require_ending(const std::string& output, const std::string& ending);

/// Removes a file, or a symbolic link; what else has the name stays, and nothing is no error. \throws OutputError
void remove_file(const std::string& path);

/// Makes a folder, with its parents. \throws OutputError
void make_folder(const std::string& path);

}  // namespace graincrack
