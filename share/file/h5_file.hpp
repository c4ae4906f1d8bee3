// Reads and writes HDF5 datasets and attributes by files and pipes, for all other sources. Files appear complete or not at all.
//
// Files use the library's default version bounds, no object times, and chunks with shuffle and deflate 1 for large arrays. An
// attribute then has less than 64 KiB. A longer text or list is stored as a dataset with the name of the attribute: in its group,
// or beside its dataset, as "/contacts/class_names". Texts are bytes, one row per text. Users of attributes do not notice.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "share/base/error.hpp"

namespace graincrack {
namespace h5 {
class Handle;
}

/// Version of the file layout that this build writes and reads; files of another one are refused.
inline constexpr int schema_version = 5;

/// Thrown for a file of the requested kind with another schema version.
class SchemaError : public InputError {
    using InputError::InputError;
};

/// Stops HDF5 from printing errors, which exceptions report. A thread calls it before it uses files that another one has opened.
void silence_hdf5();

/// Version of the HDF5 library in use, "1.10.8".
std::string hdf5_version();

/// Shape of an array, slowest index first.
using Extents = std::vector<std::size_t>;

/// A file open for reading; "-" reads an HDF5 file image from stdin.
class H5Input {
public:
    /// Opens a file. \param path a file or "-"
    /// \param kind "specimen" or "run" if the caller needs one, empty to accept both
    /// \throws InputError with one line if the file is missing, not HDF5, truncated or damaged, foreign (no format attribute), of
    ///         another schema or kind, or if stdin is empty
    explicit H5Input(const std::string& path, std::string_view kind = "");
    /// Opens the bytes of a file. A file that is still being written has the data that were flushed so far.
    /// \param name for messages
    static H5Input from_image(const std::vector<char>& image, const std::string& name, std::string_view kind = "");
    ~H5Input();
    H5Input(H5Input&&) noexcept;
    H5Input& operator=(H5Input&&) noexcept;

    [[nodiscard]] const std::string& name() const;  ///< the path, or "stdin", for messages
    [[nodiscard]] const std::string& kind() const;  ///< root attribute "kind"

    [[nodiscard]] bool has(const std::string& path) const;
    [[nodiscard]] bool has_attribute(const std::string& object, const std::string& attribute) const;
    [[nodiscard]] Extents extents(const std::string& dataset) const;
    /// Names of the links in a group, sorted.
    [[nodiscard]] std::vector<std::string> children(const std::string& group) const;

    /// Reads a whole dataset, flattened; T is double, int32_t, int64_t or uint8_t (HDF5 converts numbers as needed).
    /// \throws InputError that names file and path if it is missing or unreadable
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& dataset) const;
    /// Reads a dataset of this shape. \throws InputError before anything is read if it has another shape
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& dataset, const Extents& shape) const;

    /// Reads an attribute as double, int64_t, std::string, std::vector<double> or std::vector<std::string>.
    template <class T>
    [[nodiscard]] T attribute(const std::string& object, const std::string& attribute) const;
    /// Reads an attribute, or returns `fallback` if it is missing.
    template <class T>
    [[nodiscard]] T attribute_or(const std::string& object, const std::string& attribute, T fallback) const;

    /// SHA-256 (hex) over all paths, types, shapes, attributes and values except those of /provenance.
    [[nodiscard]] std::string digest() const;
    /// Reads every dataset once. \throws InputError for the first that cannot be read
    void check() const;
    /// One line per object: path, type, shape, unit, description.
    [[nodiscard]] std::vector<std::string> describe() const;

private:
    H5Input();
    void require_kind(std::string_view kind);
    /// The dataset that stores an attribute too long for HDF5; "" if there is none.
    [[nodiscard]] std::string long_attribute(const std::string& object, const std::string& attribute) const;
    template <class T>
    [[nodiscard]] T read_long(const std::string& dataset) const;
    friend class H5Output;
    struct State;
    std::unique_ptr<State> state_;
};

class OutputFile;

/// A file being written. It is `path`.part until `commit` flushes, syncs and renames it; without a commit nothing remains. A
/// stream, such as "-", is built in memory and sent by `commit`.
class H5Output {
public:
    /// Creates a file. \param kind "specimen" or "run"
    /// \throws UsageError if it would replace a file of another kind; OutputError if it cannot be created, or is a terminal
    H5Output(const std::string& path, std::string_view kind);
    H5Output(std::unique_ptr<OutputFile> place, std::string_view kind);
    ~H5Output();
    H5Output(H5Output&&) noexcept;
    H5Output& operator=(H5Output&&) noexcept;

    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] bool is_stream() const;

    void create_group(const std::string& group);
    /// Writes a dataset with its attributes `unit` and `description`, and creates missing parent groups.
    /// T is double, int32_t, int64_t or uint8_t. \throws OutputError if it cannot be written
    template <class T>
    void write(const std::string& dataset, std::span<const T> values, const Extents& extents, std::string_view unit,
               std::string_view description);
    /// Appends rows to a dataset that grows in its first extent; the first call creates it. \param extents of the appended rows
    template <class T>
    void append(const std::string& dataset, std::span<const T> values, const Extents& extents, std::string_view unit,
                std::string_view description);
    /// Writes or replaces an attribute: double, int64_t, std::string, std::vector<double>, std::vector<std::string>.
    template <class T>
    void attribute(const std::string& object, const std::string& attribute, const T& value);
    /// Writes a scalar quantity as the attributes X and X_unit.
    void quantity(const std::string& object, const std::string& name, double value, std::string_view unit);

    /// Copies an object of another file with its contents.
    void copy(const H5Output& from, const std::string& object, const std::string& to);
    void hard_link(const std::string& existing, const std::string& link);
    void remove(const std::string& object);
    void move(const std::string& from, const std::string& to);
    /// Writes all data so far to disk. If the program is killed later, a run can be read up to here.
    void flush();
    /// Completes the file: flush, fsync, rename (or send). \throws OutputError if it cannot be written
    void commit();

private:
    struct State;
    void create_parents(const std::string& object);
    /// Writes a dataset for an attribute that is too long for HDF5. \return false if it is not too long
    template <class T>
    bool write_if_long(const std::string& dataset, const T& value);
    /// \throws OutputError with the text `wrong` unless `done`
    void require(bool done, const std::string& wrong) const;
    void flush_file();
    /// Creates a dataset without values. \param grows true if rows will be appended to it
    template <class T>
    h5::Handle create(const std::string& dataset, const Extents& extents, bool grows);
    std::unique_ptr<State> state_;
};

/// The rows of an array of arrays as one flat span for HDF5.
template <class T, std::size_t n>
std::span<const T> flat(const std::vector<std::array<T, n>>& rows) {
    return {rows.empty() ? nullptr : rows.front().data(), rows.size() * n};
}

}  // namespace graincrack
