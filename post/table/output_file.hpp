// Files that appear whole or not at all: written as NAME.part, synced, renamed.
#pragma once

#include <string>
#include <string_view>

namespace graincrack {

/// A file that is written at the path `part()`; `commit` gives it its name. Without a commit the part is removed.
class OutputFile {
public:
    /// \throws OutputError if nothing can be written there
    explicit OutputFile(std::string path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    [[nodiscard]] const std::string& part() const { return part_; }
    /// Syncs and renames. \throws OutputError
    void commit();

private:
    std::string path_;
    std::string part_;
    bool committed_ = false;
};

/// Writes `content` to a file. \throws OutputError
void write_whole_file(const std::string& path, std::string_view content);

/// Makes a folder, with its parents. \throws OutputError
void make_folder(const std::string& path);

}  // namespace graincrack
