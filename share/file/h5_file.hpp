// The only access to HDF5: reads and writes datasets and attributes through files and pipes. Files appear complete or not at all.
//
// Files use the library's default version bounds, no object times, chunk + shuffle + deflate 1 for large arrays. With these
// bounds an attribute has less than 64 KiB. A text or list beyond that is a dataset: of a group, in it by the name of the
// attribute; of a dataset, beside it, as "/contacts/class_names". Texts are bytes, a row each. Who reads or writes an attribute
// does not see that.
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

/// A file of the wanted kind, of another schema version.
class SchemaError : public InputError {
    using InputError::InputError;
};

/// Before a thread uses what another has opened: HDF5 prints none of its errors, which are told by exceptions.
void silence_hdf5();

/// Version of the HDF5 library in use, "1.10.8".
std::string hdf5_version();

/// Shape of an array, slowest index first.
using Extents = std::vector<std::size_t>;

/// A file open for reading; "-" reads an HDF5 file image from stdin.
class H5Input {
public:
    /// \param path a file or "-"
    /// \param kind "specimen" or "run" if the caller needs one, empty to accept both
    /// \throws InputError one line: missing, not HDF5, truncated or damaged, foreign (no format attribute), another schema,
    ///         another kind than asked, or an empty stdin
    explicit H5Input(const std::string& path, std::string_view kind = "");
    /// The same from the bytes of a file. A file that is still being written holds what was flushed so far.
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

    /// Whole dataset, flattened; T is double, int32_t, int64_t or uint8_t (converted by HDF5 as needed).
    /// \throws InputError naming file and path if it is missing or unreadable
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& dataset) const;
    /// The same of a dataset that must have this shape. \throws InputError before anything is read if it has another
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& dataset, const Extents& shape) const;

    /// Attribute as double, int64_t, std::string, std::vector<double> or std::vector<std::string>.
    template <class T>
    [[nodiscard]] T attribute(const std::string& object, const std::string& attribute) const;
    /// The same with a value for a missing attribute.
    template <class T>
    [[nodiscard]] T attribute_or(const std::string& object, const std::string& attribute, T fallback) const;

    /// SHA-256 (hex) over every path, type, shape, attribute and value except /provenance.
    [[nodiscard]] std::string digest() const;
    /// Reads every dataset once; \throws InputError for the first that cannot be read.
    void check() const;
    /// One line for each object: path, type, shape, unit, description.
    [[nodiscard]] std::vector<std::string> describe() const;

private:
    H5Input();
    void require_kind(std::string_view kind);
    /// The dataset that is an attribute too long for one; "" if there is none.
    [[nodiscard]] std::string long_attribute(const std::string& object, const std::string& attribute) const;
    template <class T>
    [[nodiscard]] T read_long(const std::string& dataset) const;
    friend class H5Output;
    struct State;
    std::unique_ptr<State> state_;
};

class OutputFile;

/// A file being written: `path`.part until `commit`, which flushes, syncs and renames it. Without a commit nothing is
/// left. For a stream, such as "-", it is built in memory, and sent at `commit`.
class H5Output {
public:
    /// \param kind "specimen" or "run"
    /// \throws UsageError if it would replace a file of another kind; OutputError if it cannot be created, or is a terminal
    H5Output(const std::string& path, std::string_view kind);
    H5Output(std::unique_ptr<OutputFile> place, std::string_view kind);
    ~H5Output();
    H5Output(H5Output&&) noexcept;
    H5Output& operator=(H5Output&&) noexcept;

    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] bool is_stream() const;

    void create_group(const std::string& group);
    /// Writes a dataset with its attributes `unit` and `description`; missing parent groups are made.
    /// T is double, int32_t, int64_t or uint8_t. \throws OutputError
    template <class T>
    void write(const std::string& dataset, std::span<const T> values, const Extents& extents, std::string_view unit,
               std::string_view description);
    /// Appends rows to a dataset that grows in its first extent, creating it on the first call. `extents` are those of
    /// the appended rows.
    template <class T>
    void append(const std::string& dataset, std::span<const T> values, const Extents& extents, std::string_view unit,
                std::string_view description);
    /// Writes or replaces an attribute: double, int64_t, std::string, std::vector<double>, std::vector<std::string>.
    template <class T>
    void attribute(const std::string& object, const std::string& attribute, const T& value);
    /// A scalar quantity: attribute X and attribute X_unit.
    void quantity(const std::string& object, const std::string& name, double value, std::string_view unit);

    /// Copies an object of another file with all that is in it.
    void copy(const H5Output& from, const std::string& object, const std::string& to);
    void hard_link(const std::string& existing, const std::string& link);
    void remove(const std::string& object);
    void move(const std::string& from, const std::string& to);
    /// Writes everything so far to disk: after a kill, a run can be read up to here.
    void flush();
    /// Ends the file: flush, fsync, rename (or send). \throws OutputError
    void commit();

private:
    struct State;
    void create_parents(const std::string& object);
    /// Writes a dataset in place of an attribute that is too long for one. \return false for one that is not
    template <class T>
    bool write_if_long(const std::string& dataset, const T& value);
    /// \throws OutputError that says what is wrong
    void require(bool done, const std::string& wrong) const;
    void flush_file();
    /// Makes a dataset without values. \param grows whether rows are appended to it, which has none yet
    template <class T>
    h5::Handle create(const std::string& dataset, const Extents& extents, bool grows);
    std::unique_ptr<State> state_;
};

/// Rows of an array of arrays as one flat span, as HDF5 needs them.
template <class T, std::size_t n>
std::span<const T> flat(const std::vector<std::array<T, n>>& rows) {
    return {rows.empty() ? nullptr : rows.front().data(), rows.size() * n};
}

}  // namespace graincrack
