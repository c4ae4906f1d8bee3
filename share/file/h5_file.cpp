#include "share/file/h5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <type_traits>
#include <utility>

#include "share/base/error.hpp"
#include "share/file/deflated_chunk.hpp"
#include "share/file/h5_detail.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {

using namespace h5;

namespace {

constexpr std::size_t chunk_bytes = 1 << 18;   // target size of a chunk
constexpr std::size_t small_bytes = 1 << 12;   // smaller arrays stay contiguous
constexpr std::size_t image_growth = 1 << 16;  // growth of a file in memory; flushing writes multiples of it
constexpr unsigned deflate_level = 1;          // of arrays that grow, as in `deflated_chunk`

std::size_t product(const Extents& extents) {
    std::size_t n = 1;
    for (const std::size_t e : extents) n *= e;
    return n;
}

std::vector<hsize_t> to_hsize(const Extents& extents) { return {extents.begin(), extents.end()}; }

/// Creation properties of a dataset: contiguous when small and of fixed size, else chunked along the first extent.
Handle creation_properties(const Extents& extents, std::size_t item_bytes, bool grows) {
    Handle properties = property_list(H5P_DATASET_CREATE);
    H5Pset_obj_track_times(properties.get(), 0);
    const std::size_t bytes = product(extents) * item_bytes;
    if (extents.empty() || bytes == 0 || (!grows && bytes <= small_bytes)) return properties;
    const std::size_t row_bytes = std::max<std::size_t>(1, bytes / std::max<std::size_t>(extents[0], 1));
    std::vector<hsize_t> chunk = to_hsize(extents);
    chunk[0] = std::max<std::size_t>(1, chunk_bytes / (grows ? 16 : 1) / row_bytes);
    if (!grows) chunk[0] = std::min<hsize_t>(chunk[0], extents[0]);
    H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
    H5Pset_shuffle(properties.get());
    H5Pset_deflate(properties.get(), deflate_level);
    return properties;
}

/// Writes an array in chunks of whole rows. \return false if it cannot be written
template <class T>
bool write_chunks(hid_t dataset, const Handle& properties, std::span<const T> values, const Extents& extents) {
    std::vector<hsize_t> chunk(extents.size());
    H5Pget_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data());
    const std::size_t items = values.size() / extents[0] * chunk[0];
    std::vector<hsize_t> offset(extents.size(), 0);
    for (std::size_t first = 0; first < values.size(); first += items, offset[0] += chunk[0]) {
        const std::span<const T> part = values.subspan(first, std::min(items, values.size() - first));
        std::vector<T> whole;  // the last chunk is stored in full
        if (part.size() < items) {
            whole.assign(part.begin(), part.end());
            whole.resize(items);
        }
        const T* const begin = whole.empty() ? part.data() : whole.data();
        const auto deflated = deflated_chunk({reinterpret_cast<const unsigned char*>(begin), items * sizeof(T)}, sizeof(T));
        if (H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, offset.data(), deflated.size(), deflated.data()) < 0) return false;
    }
    return true;
}

constexpr std::size_t longest_attribute = 60'000;  // bytes; the library's limit of 65,535 includes name and type

/// Path of the dataset that replaces an attribute too long for HDF5.
std::string place_of_long(const std::string& object, const std::string& attribute, bool is_group) {
    return (object == "/" ? "" : object) + (is_group ? "/" : "_") + attribute;
}

/// Texts as rows of bytes of equal length.
std::vector<std::uint8_t> rows_of_bytes(const std::vector<std::string>& texts, std::size_t width) {
    std::vector<std::uint8_t> bytes(texts.size() * width, 0);
    for (std::size_t i = 0; i < texts.size(); ++i) std::copy(texts[i].begin(), texts[i].end(), bytes.begin() + i * width);
    return bytes;
}

std::size_t longest_of(const std::vector<std::string>& texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    return longest;
}

}  // namespace

// Errors are reported by return values, so the library's own printing, one per thread, is switched off. At exit it would try
// again to close files that it could not close, as on a full disk, and crash.
void silence_hdf5() {
    [[maybe_unused]] static const bool done = [] {
        H5dont_atexit();
        H5PLset_loading_state(0);  // files cannot make the library load code
        return true;
    }();
    [[maybe_unused]] static thread_local const bool is_silent = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
}

std::string hdf5_version() {
    silence_hdf5();
    unsigned major = 0;
    unsigned minor = 0;
    unsigned release = 0;
    H5get_libversion(&major, &minor, &release);
    return fmt::format("{}.{}.{}", major, minor, release);
}

// --- reading ---------------------------------------------------------------------------------------------------------

struct H5Input::State {
    std::string name;
    std::string kind;
    Handle file;
};

H5Input::H5Input() : state_(std::make_unique<State>()) { silence_hdf5(); }

H5Input::H5Input(const std::string& path, std::string_view kind) : H5Input() {
    if (path == "-") {
        *this = from_image(read_stdin(), "stdin", kind);
        return;
    }
    state_->name = path;
    state_->file = open_path(path);
    require_kind(kind);
}

H5Input H5Input::from_image(const std::vector<char>& image, const std::string& name, std::string_view kind) {
    H5Input input;
    input.state_->name = name;
    input.state_->file = open_image(image, name);
    input.require_kind(kind);
    return input;
}

void H5Input::require_kind(std::string_view kind) {
    if (attribute_or<std::string>("/", "format", "") != "graincrack") {
        throw InputError(
            fmt::format("{}: an HDF5 file, but not a Graincrack one (no root attribute format = graincrack)", state_->name));
    }
    require_tree(state_->file.get(), state_->name);
    state_->kind = attribute_or<std::string>("/", "kind", "");
    if (!kind.empty() && state_->kind != kind) {
        throw InputError(fmt::format("{}: is a {}, a {} is needed (graincrack-{} writes one)", state_->name,
                                     state_->kind.empty() ? "file of no known kind" : state_->kind, kind,
                                     kind == "specimen" ? "mesh" : "solve"));
    }
    if (const auto version = attribute<std::int64_t>("/", "schema_version"); version != schema_version) {
        throw SchemaError(
            fmt::format("{}: has schema version {}, but this build reads {}; {}", state_->name, version, schema_version,
                        version < schema_version ? "make the file again, or read it with the Graincrack that wrote it"
                                                 : "use a newer Graincrack"));
    }
}
H5Input::~H5Input() = default;
H5Input::H5Input(H5Input&&) noexcept = default;
H5Input& H5Input::operator=(H5Input&&) noexcept = default;

const std::string& H5Input::name() const { return state_->name; }
const std::string& H5Input::kind() const { return state_->kind; }

bool H5Input::has(const std::string& path) const {
    // H5Lexists needs every parent to exist.
    for (std::size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1)) {
        if (H5Lexists(state_->file.get(), path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    }
    return path == "/" || H5Lexists(state_->file.get(), path.c_str(), H5P_DEFAULT) > 0;
}

bool H5Input::has_attribute(const std::string& object, const std::string& attribute) const {
    return has(object) && (H5Aexists_by_name(state_->file.get(), object.c_str(), attribute.c_str(), H5P_DEFAULT) > 0 ||
                           !long_attribute(object, attribute).empty());
}

std::string H5Input::long_attribute(const std::string& object, const std::string& attribute) const {
    for (const bool is_group : {true, false}) {
        if (std::string place = place_of_long(object, attribute, is_group); has(place)) return place;
    }
    return "";
}

namespace {

Handle open_dataset(hid_t file, const std::string& file_name, const std::string& dataset) {
    Handle id(H5Dopen2(file, dataset.c_str(), H5P_DEFAULT), H5Dclose);
    if (!id.valid()) throw InputError(fmt::format("{}: dataset {} is missing", file_name, dataset));
    return id;
}

}  // namespace

Extents H5Input::extents(const std::string& dataset) const {
    const Handle id = open_dataset(state_->file.get(), state_->name, dataset);
    return space_extents(space_of_dataset(id.get()).get());
}

std::vector<std::string> H5Input::children(const std::string& group) const {
    return has(group) ? link_names(state_->file.get(), group) : std::vector<std::string>{};
}

template <class T>
std::vector<T> H5Input::read(const std::string& dataset) const {
    const Handle id = open_dataset(state_->file.get(), state_->name, dataset);
    std::vector<T> values(require_readable(id.get(), state_->name, dataset));
    if (!values.empty() && H5Dread(id.get(), number_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
        throw InputError(
            fmt::format("{}: dataset {} cannot be read: the file is damaged or the type is wrong", state_->name, dataset));
    }
    return values;
}

template <class T>
std::vector<T> H5Input::read(const std::string& dataset, const Extents& shape) const {
    if (const Extents own = extents(dataset); own != shape) {
        throw InputError(fmt::format("{}: dataset {} has the shape {}, not {}", state_->name, dataset, extents_text(own),
                                     extents_text(shape)));
    }
    return read<T>(dataset);
}

template <class T>
T H5Input::read_long(const std::string& dataset) const {
    if constexpr (std::is_arithmetic_v<T>) {
        throw InputError(fmt::format("{}: {} is a dataset, where a number is needed", state_->name, dataset));
    } else if constexpr (std::is_same_v<T, std::string>) {
        const std::vector<std::uint8_t> bytes = read<std::uint8_t>(dataset);
        return {bytes.begin(), bytes.end()};
    } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
        const std::vector<std::uint8_t> bytes = read<std::uint8_t>(dataset);
        const Extents shape = extents(dataset);
        T texts;
        for (auto row = bytes.begin(); shape.size() == 2 && row != bytes.end(); row += static_cast<std::ptrdiff_t>(shape[1])) {
            texts.emplace_back(row, std::find(row, row + static_cast<std::ptrdiff_t>(shape[1]), 0));
        }
        return texts;
    } else {
        return read<typename T::value_type>(dataset);
    }
}

template <class T>
T H5Input::attribute(const std::string& object, const std::string& attribute) const {
    if (!has_attribute(object, attribute)) {
        throw InputError(fmt::format("{}: attribute {} of {} is missing", state_->name, attribute, object));
    }
    if (H5Aexists_by_name(state_->file.get(), object.c_str(), attribute.c_str(), H5P_DEFAULT) <= 0) {
        return read_long<T>(long_attribute(object, attribute));
    }
    const Handle id(H5Aopen_by_name(state_->file.get(), object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (id.valid()) require_readable_attribute(id.get(), state_->name, object, attribute);
    T value{};
    if (!id.valid() || !read_attribute(id.get(), value)) {
        throw InputError(fmt::format("{}: attribute {} of {} has an unexpected type", state_->name, attribute, object));
    }
    return value;
}

template <class T>
T H5Input::attribute_or(const std::string& object, const std::string& name, T fallback) const {
    return has_attribute(object, name) ? attribute<T>(object, name) : fallback;
}

std::string H5Input::digest() const { return h5::digest(state_->file.get(), state_->name, "/provenance"); }

void H5Input::check() const { static_cast<void>(h5::digest(state_->file.get(), state_->name, "")); }

std::vector<std::string> H5Input::describe() const { return h5::describe(state_->file.get(), state_->name); }

// --- writing ---------------------------------------------------------------------------------------------------------

struct H5Output::State {
    std::unique_ptr<OutputFile> place;
    /// For a stream, and a checkpoint: HDF5 1.10.8 crashes if the disk is full while it copies frames between files (H5Ocopy).
    bool is_in_memory;
    Handle file;
};

namespace {

void write_meaning(hid_t dataset, std::string_view unit, std::string_view description) {
    write_attribute(dataset, "unit", std::string(unit));
    write_attribute(dataset, "description", std::string(description));
}

std::string unwritten(const std::string& dataset) {
    return fmt::format("dataset {} cannot be written; is the disk full?", dataset);
}

/// Checks a file that an output would replace. \throws UsageError if it is of another kind
void require_kind_of_replaced(const OutputFile& place, std::string_view kind) {
    const std::string replaced = place.replaced();
    if (replaced.empty()) return;
    try {
        const H5Input existing(replaced, kind);
    } catch (const SchemaError&) {  // of this kind, in an older format
    } catch (const InputError&) {
        throw UsageError(
            fmt::format("{}: exists, and is no {} that could be replaced; give another name, or remove it", place.name(), kind));
    }
}

}  // namespace

H5Output::H5Output(const std::string& path, std::string_view kind) : H5Output(std::make_unique<OutputFile>(path), kind) {}

H5Output::H5Output(std::unique_ptr<OutputFile> place, std::string_view kind)
    : state_(std::make_unique<State>(State{std::move(place), false, {}})) {
    silence_hdf5();
    const Handle access = property_list(H5P_FILE_ACCESS);
    Handle creation = property_list(H5P_FILE_CREATE);
    H5Pset_obj_track_times(creation.get(), 0);
    std::string path = "graincrack-image";
    state_->is_in_memory = is_stream() || state_->place->is_covered();
    if (state_->is_in_memory) {
        H5Pset_fapl_core(access.get(), image_growth, is_stream() ? 0 : 1);  // a named one is written on flushing
    }
    require(!state_->place->is_terminal(), "is a terminal; send the file into a pipe or name one with -o FILE");
    if (!is_stream()) {
        require_kind_of_replaced(*state_->place, kind);
        path = state_->place->begin();
    }
    state_->file = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose);
    require(state_->file.valid(), "cannot be created");
    attribute("/", "format", std::string("graincrack"));
    attribute("/", "schema_version", std::int64_t{schema_version});
    attribute("/", "kind", std::string(kind));
}
H5Output::~H5Output() = default;
H5Output::H5Output(H5Output&&) noexcept = default;
H5Output& H5Output::operator=(H5Output&&) noexcept = default;

const std::string& H5Output::name() const { return state_->place->name(); }
bool H5Output::is_stream() const { return state_->place->is_stream(); }

void H5Output::create_group(const std::string& group) {
    for (std::size_t slash = group.find('/', 1);; slash = group.find('/', slash + 1)) {
        const std::string path = group.substr(0, slash);
        if (path.size() > 1 && H5Lexists(state_->file.get(), path.c_str(), H5P_DEFAULT) <= 0) {
            const Handle properties = property_list(H5P_GROUP_CREATE);
            H5Pset_obj_track_times(properties.get(), 0);
            const Handle id(H5Gcreate2(state_->file.get(), path.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Gclose);
            require(id.valid(), fmt::format("group {} cannot be created", path));
        }
        if (slash == std::string::npos) return;
    }
}

void H5Output::create_parents(const std::string& object) {
    if (const std::size_t slash = object.rfind('/'); slash > 0 && slash != std::string::npos) {
        create_group(object.substr(0, slash));
    }
}

template <class T>
Handle H5Output::create(const std::string& dataset, const Extents& extents, bool grows) {
    create_parents(dataset);
    std::vector<hsize_t> shape = to_hsize(extents);
    std::vector<hsize_t> limit = shape;
    Extents row = extents;
    if (grows) {
        shape[0] = 0;
        limit[0] = H5S_UNLIMITED;
        row[0] = std::max<std::size_t>(row[0], 1);
    }
    const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), limit.data()), H5Sclose);
    const Handle properties = creation_properties(row, sizeof(T), grows);
    Handle id(H5Dcreate2(state_->file.get(), dataset.c_str(), number_type<T>(), space.get(), H5P_DEFAULT, properties.get(),
                         H5P_DEFAULT),
              H5Dclose);
    require(id.valid(), unwritten(dataset));
    return id;
}

template <class T>
void H5Output::write(const std::string& dataset, std::span<const T> values, const Extents& extents, std::string_view unit,
                     std::string_view description) {
    if (values.size() != product(extents)) throw std::logic_error("dataset " + dataset + ": values do not fill its extents");
    const Handle id = create<T>(dataset, extents, false);
    const Handle properties(H5Dget_create_plist(id.get()), H5Pclose);
    const bool is_written =
        values.empty() || (H5Pget_layout(properties.get()) == H5D_CHUNKED
                               ? write_chunks(id.get(), properties, values, extents)
                               : H5Dwrite(id.get(), number_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    require(is_written, unwritten(dataset));
    write_meaning(id.get(), unit, description);
}

template <class T>
void H5Output::append(const std::string& dataset, std::span<const T> values, const Extents& extents, std::string_view unit,
                      std::string_view description) {
    if (values.size() != product(extents) || extents.empty()) {
        throw std::logic_error("dataset " + dataset + ": values do not fill its extents");
    }
    if (H5Lexists(state_->file.get(), dataset.c_str(), H5P_DEFAULT) <= 0) {
        write_meaning(create<T>(dataset, extents, true).get(), unit, description);
    }
    const Handle id(H5Dopen2(state_->file.get(), dataset.c_str(), H5P_DEFAULT), H5Dclose);
    std::vector<hsize_t> shape = to_hsize(space_extents(space_of_dataset(id.get()).get()));
    std::vector<hsize_t> offset(extents.size(), 0);
    offset[0] = shape[0];
    shape[0] += extents[0];
    require(H5Dset_extent(id.get(), shape.data()) >= 0, fmt::format("dataset {} cannot be extended; is the disk full?", dataset));
    const Handle space = space_of_dataset(id.get());
    const std::vector<hsize_t> count = to_hsize(extents);
    H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, offset.data(), nullptr, count.data(), nullptr);
    const Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
    require(values.empty() || H5Dwrite(id.get(), number_type<T>(), memory.get(), space.get(), H5P_DEFAULT, values.data()) >= 0,
            unwritten(dataset));
}

template <class T>
void H5Output::attribute(const std::string& object, const std::string& attribute, const T& value) {
    const Handle id(H5Oopen(state_->file.get(), object.c_str(), H5P_DEFAULT), H5Oclose);
    if (!id.valid()) throw std::logic_error("attribute " + attribute + ": no object " + object);
    if constexpr (std::is_arithmetic_v<T>) {
        write_attribute(id.get(), attribute, value);
    } else {
        const std::string place = place_of_long(object, attribute, H5Iget_type(id.get()) == H5I_GROUP);
        if (!write_if_long(place, value)) {
            write_attribute(id.get(), attribute, value);
        } else if (H5Aexists(id.get(), attribute.c_str()) > 0) {
            H5Adelete(id.get(), attribute.c_str());
        }
    }
}

template <class T>
bool H5Output::write_if_long(const std::string& dataset, const T& value) {
    constexpr bool is_text = std::is_same_v<T, std::string>;
    constexpr bool is_texts = std::is_same_v<T, std::vector<std::string>>;
    const std::size_t width = [&] {
        if constexpr (is_texts) return longest_of(value);
        return sizeof(typename T::value_type);
    }();
    if (value.size() * width <= longest_attribute) return false;
    if (H5Lexists(state_->file.get(), dataset.c_str(), H5P_DEFAULT) > 0) remove(dataset);
    constexpr std::string_view meaning = "too long for an attribute";
    if constexpr (is_text) {
        const std::vector<std::uint8_t> bytes(value.begin(), value.end());
        write<std::uint8_t>(dataset, bytes, {bytes.size()}, "1", meaning);
    } else if constexpr (is_texts) {
        write<std::uint8_t>(dataset, rows_of_bytes(value, width), {value.size(), width}, "1", meaning);
    } else {
        write<typename T::value_type>(dataset, value, {value.size()}, "1", meaning);
    }
    return true;
}

void H5Output::quantity(const std::string& object, const std::string& name, double value, std::string_view unit) {
    attribute(object, name, value);
    attribute(object, name + "_unit", std::string(unit));
}

void H5Output::require(bool done, const std::string& wrong) const {
    if (!done) throw OutputError(fmt::format("{}: {}", name(), wrong));
}

void H5Output::hard_link(const std::string& existing, const std::string& link) {
    create_parents(link);
    const hid_t file = state_->file.get();
    require(H5Lcreate_hard(file, existing.c_str(), file, link.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0,
            fmt::format("{} cannot be linked to {}", link, existing));
}

void H5Output::copy(const H5Output& from, const std::string& object, const std::string& to) {
    require(H5Ocopy(from.state_->file.get(), object.c_str(), state_->file.get(), to.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0,
            to + " cannot be written; is the disk full?");
}

void H5Output::remove(const std::string& object) { H5Ldelete(state_->file.get(), object.c_str(), H5P_DEFAULT); }

void H5Output::move(const std::string& from, const std::string& to) {
    const hid_t file = state_->file.get();
    require(H5Lmove(file, from.c_str(), file, to.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0,
            fmt::format("{} cannot be renamed to {}", from, to));
}

void H5Output::flush() {
    if (!state_->is_in_memory) flush_file();
}

void H5Output::flush_file() {
    require(H5Fflush(state_->file.get(), H5F_SCOPE_GLOBAL) >= 0, "cannot be flushed; is the disk full?");
}

void H5Output::commit() {
    flush_file();
    if (is_stream()) {
        const ssize_t size = H5Fget_file_image(state_->file.get(), nullptr, 0);
        std::string image(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
        require(size > 0 && H5Fget_file_image(state_->file.get(), image.data(), image.size()) >= 0,
                "the file image cannot be made");
        state_->place->write(image);
    } else {
        require(state_->file.reset(), "cannot be closed; is the disk full?");
    }
    state_->place->commit();
}

// --- instantiations of the templates -----------------------------------------------------------------------------------

#define GRAINCRACK_READ(T)                                              \
    template std::vector<T> H5Input::read<T>(const std::string&) const; \
    template std::vector<T> H5Input::read<T>(const std::string&, const Extents&) const;
GRAINCRACK_READ(double)
GRAINCRACK_READ(std::int32_t)
GRAINCRACK_READ(std::int64_t)
GRAINCRACK_READ(std::uint8_t)
#undef GRAINCRACK_READ

#define GRAINCRACK_WRITE(T)                                                                                    \
    template void H5Output::write<T>(const std::string&, std::span<const T>, const Extents&, std::string_view, \
                                     std::string_view);                                                        \
    template void H5Output::append<T>(const std::string&, std::span<const T>, const Extents&, std::string_view, std::string_view);
GRAINCRACK_WRITE(double)
GRAINCRACK_WRITE(std::int32_t)
GRAINCRACK_WRITE(std::int64_t)
GRAINCRACK_WRITE(std::uint8_t)
#undef GRAINCRACK_WRITE

#define GRAINCRACK_ATTRIBUTE(T)                                                           \
    template T H5Input::attribute<T>(const std::string&, const std::string&) const;       \
    template T H5Input::attribute_or<T>(const std::string&, const std::string&, T) const; \
    template void H5Output::attribute<T>(const std::string&, const std::string&, const T&);
GRAINCRACK_ATTRIBUTE(double)
GRAINCRACK_ATTRIBUTE(std::int64_t)
GRAINCRACK_ATTRIBUTE(std::string)
GRAINCRACK_ATTRIBUTE(std::vector<double>)
GRAINCRACK_ATTRIBUTE(std::vector<std::int64_t>)
GRAINCRACK_ATTRIBUTE(std::vector<std::string>)
#undef GRAINCRACK_ATTRIBUTE

}  // namespace graincrack
