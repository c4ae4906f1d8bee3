#include "mesher/import/gmsh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t longest_shown = 40;
constexpr std::string_view white_space = " \t\r\n\f\v";

std::string shown(std::string_view text) { return printable(std::string(text.substr(0, longest_shown))); }

template <typename T>
bool parse(std::string_view text, T& value) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc{} && result.ptr == text.data() + text.size();
}

/// A place in the text of a file. Missing or unexpected content is an InputError naming the file, the line and what was found. A
/// number of the file is a size only after so many bytes are known to follow.
class MeshText {
public:
    MeshText(std::string_view bytes, std::string name) : bytes_(bytes), name_(std::move(name)) {}

    /// True if only white space follows.
    bool at_end() {
        skip_white_space();
        return place_ == bytes_.size();
    }

    /// The rest of the line without surrounding white space; "" at the end of the file.
    std::string_view line() {
        const std::size_t end = std::min(bytes_.find('\n', place_), bytes_.size());
        const std::string_view text = bytes_.substr(place_, end - place_);
        place_ = std::min(end + 1, bytes_.size());
        ++line_;
        return trimmed(text);
    }

    std::string_view word(const char* what) {
        skip_white_space();
        if (place_ == bytes_.size()) fail(fmt::format("the file ends where {} is expected", what));
        const std::size_t end = std::min(bytes_.find_first_of(white_space, place_), bytes_.size());
        const std::string_view text = bytes_.substr(place_, end - place_);
        place_ = end;
        return text;
    }

    /// Reads an integer, or a finite number.
    std::int64_t integer(const char* what) {
        const std::string_view text = word(what);
        std::int64_t value = 0;
        if (!parse(text, value)) fail(fmt::format("\"{}\" stands where {} is expected, an integer", shown(text), what));
        return value;
    }

    double number(const char* what) {
        const std::string_view text = word(what);
        double value = 0;
        if (!parse(text, value) || !std::isfinite(value)) {
            fail(fmt::format("\"{}\" stands where {} is expected, a number", shown(text), what));
        }
        return value;
    }

    /// Reads a number of items that follow, each of at least some bytes.
    std::size_t count(const char* what, std::size_t bytes_each = 1) {
        const std::int64_t value = integer(what);
        if (value < 0 || static_cast<std::uint64_t>(value) > (bytes_.size() - place_) / bytes_each) {
            fail(fmt::format("{} is {}, for which the file is too short", what, value));
        }
        return static_cast<std::size_t>(value);
    }

    /// Reads a text in double quotes.
    std::string quoted(const char* what) {
        skip_white_space();
        const std::size_t end =
            place_ < bytes_.size() && bytes_[place_] == '"' ? bytes_.find('"', place_ + 1) : std::string::npos;
        if (end == std::string_view::npos) fail(fmt::format("{} is expected, between double quotes", what));
        std::string text(bytes_.substr(place_ + 1, end - place_ - 1));
        place_ = end + 1;
        return text;
    }

    /// Skips lines up to one that equals `text`. \return false if there is none
    bool skip_to(std::string_view text) {
        while (place_ < bytes_.size()) {
            if (line() == text) return true;
        }
        return false;
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_, message));
    }

private:
    void skip_white_space() {
        while (place_ < bytes_.size() && white_space.find(bytes_[place_]) != std::string_view::npos) {
            if (bytes_[place_++] == '\n') ++line_;
        }
    }

    std::string_view bytes_;
    std::string name_;
    std::size_t place_ = 0, line_ = 1;
};

/// Number of corners of elements by type number of the format.
const std::map<std::int64_t, int> corners_of_type{{15, 1}, {1, 2}, {2, 3}, {3, 4}};

class GmshReader {
public:
    GmshReader(std::string_view bytes, const std::string& name) : text_(bytes, name) {}

    FileMesh read() {
        read_header();
        while (!text_.at_end()) {
            const std::string section(text_.line());
            if (section.size() < 2 || section.front() != '$') text_.fail("a section is expected, such as $Nodes");
            read_section(section);
            if (!text_.skip_to("$End" + section.substr(1))) text_.fail(fmt::format("{} has no end", section));
        }
        finish();
        return std::move(mesh_);
    }

private:
    void read_header() {
        if (text_.line() != "$MeshFormat") text_.fail("$MeshFormat is expected");
        const double version = text_.number("the version of the format");
        const bool is_binary = text_.integer("the type of the file") == 1;
        const std::int64_t size = text_.integer("the size of a number");
        if (is_binary) text_.fail("the file is binary; text is needed (gmsh FILE -save -bin 0)");
        if (version >= 2 && version < 3) version_ = 2;
        if (version >= 4.1 && version < 5) version_ = 4;
        if (version_ == 0) {
            text_.fail(fmt::format("the format is MSH {:g}; 2.2 or 4.1 is needed (gmsh FILE -save -format msh41)", version));
        }
        if (size != 8) text_.fail(fmt::format("numbers of {} bytes; 8 are needed", size));
        mesh_.format = fmt::format("Gmsh {:g}, text", version);
        mesh_.without_groups =
            "physical groups: none, so that all grains are of one phase (Gmsh's Mesh.SaveAll drops them in MSH 2.2)";
        if (!text_.skip_to("$EndMeshFormat")) text_.fail("$MeshFormat has no end");
    }

    void read_section(const std::string& section) {
        if (section == "$PhysicalNames") {
            read_physical_names();
        } else if (version_ == 4 && section == "$PartitionedEntities") {
            text_.fail("the mesh is partitioned; give it in one part (in Gmsh: Mesh, Unpartition)");
        } else if (version_ == 4 && section == "$Entities") {
            read_entities();
        } else if (section == "$Nodes") {
            if (version_ == 2) read_nodes_2();
            if (version_ == 4) read_nodes_4();
        } else if (section == "$Elements") {
            if (version_ == 2) read_elements_2();
            if (version_ == 4) read_elements_4();
        } else if (section == "$Groups") {
            read_groups();
        } else if (section == "$MeshVersion") {
            is_neper_ = true;
        }
    }

    void read_physical_names() {
        for (std::size_t n = text_.count("the number of physical names", 5); n > 0; --n) {
            const std::int64_t dimension = text_.integer("the dimension of a physical group");
            const std::int64_t number = text_.integer("the number of a physical group");
            const std::string name = text_.quoted("the name of a physical group");
            if (dimension == 1) mesh_.line_names[number] = name;
            if (dimension == 2) mesh_.surface_names[number] = name;
        }
    }

    /// Reads Neper's groups of elsets, such as minerals.
    void read_groups() {
        if (text_.word("the kind of a group") != "elset") return;
        for (std::size_t n = text_.count("the number of elsets", 4); n > 0; --n) {
            const std::int64_t elset = text_.integer("an elset");
            mesh_.group_of_entity[elset] = text_.integer("the group of an elset");
        }
    }

    void read_entities() {
        std::array<std::size_t, 4> n_entities{};
        for (std::size_t& n : n_entities) n = text_.count("the number of entities", 2);
        for (int dimension = 0; dimension < 4; ++dimension) {
            for (std::size_t i = 0; i < n_entities[static_cast<std::size_t>(dimension)]; ++i) read_entity(dimension);
        }
    }

    void read_entity(int dimension) {
        const std::int64_t tag = text_.integer("the tag of an entity");
        std::int64_t first = 0;
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) text_.number("a bound of an entity");
        const std::size_t n_physical = text_.count("the number of physical groups of an entity", 2);
        for (std::size_t i = 0; i < n_physical; ++i) {
            const std::int64_t physical = text_.integer("a physical group");
            if (i == 0) first = physical;
        }
        if (n_physical > 1 && dimension == 2) {
            mesh_.notes.emplace_back(
                fmt::format("entity {} is of {} physical groups: the first, {}, counts", tag, n_physical, first),
                "several_groups");
        }
        if (dimension > 0) {
            for (std::size_t n = text_.count("the number of bounding entities", 2); n > 0; --n) text_.integer("an entity");
        }
        if (dimension == 1 || dimension == 2) physical_of_[{dimension, tag}] = first;
    }

    void add_node(std::int64_t number, const std::array<double, 3>& position) {
        mesh_.node_numbers.push_back(number);
        mesh_.positions.push_back(position);
    }

    std::array<double, 3> position() {
        std::array<double, 3> p{};
        for (double& coordinate : p) coordinate = text_.number("a coordinate");
        return p;
    }

    void read_nodes_2() {
        const std::size_t n_nodes = text_.count("the number of nodes", 8);
        for (std::size_t i = 0; i < n_nodes; ++i) {
            const std::int64_t number = text_.integer("the number of a node");
            add_node(number, position());
        }
    }

    void read_nodes_4() {
        const std::size_t n_blocks = text_.count("the number of blocks of nodes", 4);
        for (int k = 0; k < 3; ++k) text_.integer("the head of nodes");
        std::vector<std::int64_t> numbers;
        for (std::size_t block = 0; block < n_blocks; ++block) {
            const std::int64_t dimension = text_.integer("the dimension of a block of nodes");
            text_.integer("the entity of a block of nodes");
            const std::int64_t parameters = text_.integer("whether nodes have parameters") != 0 ? dimension : 0;
            const std::size_t n_nodes = text_.count("the number of nodes of a block", 8);
            numbers.clear();
            for (std::size_t i = 0; i < n_nodes; ++i) numbers.push_back(text_.integer("the number of a node"));
            for (const std::int64_t number : numbers) {
                add_node(number, position());
                for (std::int64_t k = 0; k < parameters; ++k) text_.number("a parameter of a node");
            }
        }
    }

    int corners_of(std::int64_t type) {
        const auto found = corners_of_type.find(type);
        if (found != corners_of_type.end()) return found->second;
        text_.fail(
            fmt::format("elements of type {}; triangles (2) or quadrangles (3) are needed (gmsh FILE -save -order 1)", type));
    }

    /// Reads the nodes of an element and stores it unless it is a point.
    void add_element(int n_corners, FileElement element) {
        element.n_corners = n_corners;
        for (int k = 0; k < n_corners; ++k) element.nodes[index(k)] = text_.integer("a node of an element");
        if (n_corners > 1) mesh_.elements.push_back(element);
    }

    void read_elements_2() {
        std::size_t n_elements = text_.count("the number of elements", 4);
        for (; n_elements > 0; --n_elements) {
            FileElement element;
            element.number = text_.integer("the number of an element");
            const int n_corners = corners_of(text_.integer("the type of an element"));
            const std::size_t n_tags = text_.count("the number of tags of an element");
            for (std::size_t k = 0; k < n_tags; ++k) {
                const std::int64_t tag = text_.integer("a tag of an element");
                if (k == 0) element.physical = tag;
                if (k == 1) element.entity = tag;
            }
            add_element(n_corners, element);
        }
    }

    void read_elements_4() {
        const std::size_t n_blocks = text_.count("the number of blocks of elements", 4);
        for (int k = 0; k < 3; ++k) text_.integer("the head of elements");
        for (std::size_t block = 0; block < n_blocks; ++block) {
            const std::int64_t dimension = text_.integer("the dimension of a block of elements");
            const std::int64_t tag = text_.integer("the entity of a block of elements");
            const int n_corners = corners_of(text_.integer("the type of elements"));
            const std::size_t n_elements = text_.count("the number of elements of a block", 4);
            const auto found = physical_of_.find({dimension, tag});
            for (std::size_t i = 0; i < n_elements; ++i) {
                FileElement element;
                element.number = text_.integer("the number of an element");
                element.entity = tag;
                element.physical = found == physical_of_.end() ? 0 : found->second;
                add_element(n_corners, element);
            }
        }
    }

    /// Completes what needs the whole file.
    void finish() {
        if (mesh_.node_numbers.empty()) text_.fail("no nodes");
        if (mesh_.elements.empty()) text_.fail("no lines, triangles or quadrangles");
        if (!is_neper_) return;
        mesh_.format = "Neper (" + mesh_.format + ")";
        mesh_.without_groups = "groups: none, so that all grains are of one phase";
        // Its physical groups are elsets: grains and the edges between them.
        mesh_.line_names.clear();
        mesh_.surface_names.clear();
        for (FileElement& element : mesh_.elements) element.physical = 0;
    }

    MeshText text_;
    FileMesh mesh_;
    int version_ = 0;
    bool is_neper_ = false;
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> physical_of_;  ///< group by dimension and tag; 0: none
};

}  // namespace

bool is_gmsh(std::string_view bytes) { return bytes.substr(0, 11) == "$MeshFormat"; }

FileMesh read_gmsh(std::string_view bytes, const std::string& name) { return GmshReader(bytes, name).read(); }

}  // namespace graincrack::mesher
