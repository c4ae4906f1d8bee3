#include "mesher/import/abaqus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <regex>
#include <unordered_map>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t longest_set_name = 80;

struct AbaqusElement {
    std::string_view name;  ///< the letters and digits that types of one kind begin with
    int n_corners;
};
/// The first that fits counts. Letters behind, as R and H, say how an element is integrated.
constexpr std::array abaqus_elements{
    AbaqusElement{"CPS3", 3},  AbaqusElement{"CPE3", 3}, AbaqusElement{"CAX3", 3},   AbaqusElement{"S3", 3},
    AbaqusElement{"STRI3", 3}, AbaqusElement{"M3D3", 3}, AbaqusElement{"SFM3D3", 3}, AbaqusElement{"CPS4", 4},
    AbaqusElement{"CPE4", 4},  AbaqusElement{"CAX4", 4}, AbaqusElement{"S4", 4},     AbaqusElement{"M3D4", 4},
    AbaqusElement{"T2D2", 2},  AbaqusElement{"T3D2", 2}, AbaqusElement{"B21", 2},    AbaqusElement{"B31", 2},
    AbaqusElement{"R2D2", 2},
};

std::string upper(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return result;
}

/// The fields of a line, without those behind a comma at its end.
std::vector<std::string_view> fields_of_line(std::string_view line) {
    std::vector<std::string_view> fields = split(line, ',');
    for (std::string_view& field : fields) field = trimmed(field);
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
    return fields;
}

class AbaqusReader {
public:
    AbaqusReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    FileMesh read() {
        for (std::size_t from = 0; from < bytes_.size();) {
            const std::size_t end = std::min(bytes_.find('\n', from), bytes_.size());
            const std::string_view line = trimmed(bytes_.substr(from, end - from));
            from = end + 1;
            ++line_;
            if (line.empty() || line.substr(0, 2) == "**") continue;
            if (line.front() == '*') {
                begin_keyword(line);
            } else if (keyword_ == "*NODE") {
                add_node(fields_of_line(line));
            } else if (keyword_ == "*ELEMENT") {
                add_element(line);
            } else if (keyword_ == "*ELSET") {
                add_to_set(fields_of_line(line));
            }
        }
        if (!element_fields_.empty()) fail("the file ends within an element");
        if (mesh_.node_numbers.empty()) fail("no *Node");
        if (mesh_.elements.empty()) fail("no *Element");
        give_sets();
        // Lines stand set by set; their order is that of their numbers.
        const auto place = [](const FileElement& element) { return element.n_corners > 2 ? 0 : element.number; };
        std::stable_sort(mesh_.elements.begin(), mesh_.elements.end(),
                         [&](const FileElement& l, const FileElement& r) { return place(l) < place(r); });
        mesh_.format = "Abaqus";
        mesh_.without_groups = "elsets of phases: none, so that all grains are of one phase";
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_, message));
    }
    static std::string shown(std::string_view text) { return printable(std::string(text.substr(0, 40))); }

    template <typename T>
    T value(std::string_view text, const char* what) const {
        T number{};
        if (!text.empty() && text.front() == '+') text.remove_prefix(1);
        const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
        if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) {
            fail(fmt::format("\"{}\" stands where {} is expected", shown(text), what));
        }
        return number;
    }
    [[nodiscard]] std::int64_t integer(std::string_view text, const char* what) const { return value<std::int64_t>(text, what); }

    /// A keyword with its parameters: *Elset, elset=face1, generate.
    void begin_keyword(std::string_view line) {
        if (!element_fields_.empty()) fail("a keyword stands within an element");
        const auto parts = fields_of_line(line);
        keyword_ = upper(parts.empty() ? "" : parts.front());
        is_generated_ = false;
        set_.clear();
        std::string type;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const std::size_t equals = parts[i].find('=');
            const std::string key = upper(trimmed(parts[i].substr(0, equals)));
            std::string text(equals == std::string_view::npos ? "" : trimmed(parts[i].substr(equals + 1)));
            text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
            if (key == "TYPE") type = upper(text);
            if (key == "ELSET") set_ = text;
            if (key == "GENERATE") is_generated_ = true;
            if (key == "INPUT") fail(keyword_ + " is in another file, which is not read; put it into this one");
        }
        if (keyword_ == "*INCLUDE") fail("*Include is not read; put the other file into this one");
        if ((keyword_ == "*INSTANCE" || keyword_ == "*PART") && ++parts_[keyword_] > 1) {
            fail("a second part or instance; one is needed, with all grains");
        }
        if (keyword_ == "*ELEMENT") begin_elements(type);
        if (keyword_ == "*ELSET" && set_.empty()) fail("*Elset has no name; elset=NAME is needed");
        if (set_.size() > longest_set_name) {
            fail(fmt::format("the name of an elset has {} letters; at most {} are read", set_.size(), longest_set_name));
        }
    }

    void begin_elements(const std::string& type) {
        const auto* const found = std::find_if(abaqus_elements.begin(), abaqus_elements.end(), [&](const AbaqusElement& t) {
            if (type.substr(0, t.name.size()) != t.name) return false;
            return type.size() == t.name.size() || std::isdigit(static_cast<unsigned char>(type[t.name.size()])) == 0;
        });
        if (found == abaqus_elements.end()) {
            fail(fmt::format(
                "elements of type \"{}\" are not read; triangles or quadrangles of the plane and of first order (CPE3, CPS3, "
                "CPE4, …) are needed",
                shown(type)));
        }
        type_ = found;
    }

    void add_node(const std::vector<std::string_view>& fields) {
        if (fields.size() < 3 || fields.size() > 7) fail("a node needs a number, x and y");
        mesh_.node_numbers.push_back(integer(fields[0], "the number of a node"));
        std::array<double, 3> p{};
        for (std::size_t k = 0; k < 3 && k + 1 < fields.size(); ++k) {
            p[k] = value<double>(fields[k + 1], "a coordinate");
            if (!std::isfinite(p[k])) fail("a coordinate is not finite");
        }
        mesh_.positions.push_back(p);
    }

    /// An element may go on in the next line, after a comma.
    void add_element(std::string_view line) {
        for (const std::string_view field : fields_of_line(line)) element_fields_.push_back(field);
        const std::size_t n_nodes = static_cast<std::size_t>(type_->n_corners);
        if (element_fields_.size() < n_nodes + 1 && line.back() == ',') return;
        if (element_fields_.size() != n_nodes + 1) {
            fail(fmt::format("{} fields; the number of an element and its {} nodes are needed", element_fields_.size(), n_nodes));
        }
        FileElement element;
        element.number = integer(element_fields_[0], "the number of an element");
        element.n_corners = type_->n_corners;
        for (std::size_t k = 0; k < n_nodes; ++k) element.nodes[k] = integer(element_fields_[k + 1], "a node of an element");
        element_fields_.clear();
        if (!index_.emplace(element.number, mesh_.elements.size()).second) {
            fail(fmt::format("element {} stands twice in the file", element.number));
        }
        mesh_.elements.push_back(element);
        if (!set_.empty()) set_named(set_).push_back(element.number);
    }

    std::vector<std::int64_t>& set_named(const std::string& name) {
        const auto [place, is_new] = sets_.try_emplace(name);
        if (is_new) set_order_.push_back(name);
        return place->second;
    }

    void add_to_set(const std::vector<std::string_view>& fields) {
        std::vector<std::int64_t>& set = set_named(set_);
        if (is_generated_) {
            if (fields.size() < 2 || fields.size() > 3) fail("generate needs a first and a last element, and a step or none");
            const std::int64_t first = integer(fields[0], "an element");
            const std::int64_t last = integer(fields[1], "an element");
            const std::int64_t step = fields.size() == 3 ? integer(fields[2], "a step") : 1;
            if (step < 1 || last < first || (last - first) / step > static_cast<std::int64_t>(bytes_.size())) {
                fail(fmt::format("{} to {} by {} cannot be elements of this file", first, last, step));
            }
            for (std::int64_t number = first; number <= last; number += step) set.push_back(number);
            return;
        }
        for (const std::string_view field : fields) {
            if (!field.empty() && std::isalpha(static_cast<unsigned char>(field.front())) != 0) {
                const auto other = sets_.find(std::string(field));
                if (other == sets_.end() || other->first == set_) {
                    fail(fmt::format("elset \"{}\" stands in another before it is known", shown(field)));
                }
                set.insert(set.end(), other->second.begin(), other->second.end());
            } else {
                set.push_back(integer(field, "an element"));
            }
        }
    }

    /// Elsets become grains, phases and names of lines.
    void give_sets() {
        const std::regex grain("(face|surface|grain|poly|cell|crystal)[_-]?([0-9]{1,15})", std::regex::icase);
        const std::regex line("(line|edge|curve)[_-]?[0-9]+", std::regex::icase);
        const std::regex prefix("(elset|phase|mineral)[_-]", std::regex::icase);
        const auto n_surfaces = std::count_if(mesh_.elements.begin(), mesh_.elements.end(),
                                              [](const FileElement& element) { return element.n_corners > 2; });
        std::int64_t physical = 0;
        for (const std::string& set : set_order_) {
            std::vector<FileElement*> elements;
            for (const std::int64_t number : sets_.at(set)) {
                const auto found = index_.find(number);
                if (found == index_.end()) {
                    throw InputError(
                        fmt::format("{}: elset {} names element {}, which is not in the file", name_, shown(set), number));
                }
                elements.push_back(&mesh_.elements[found->second]);
            }
            const auto n_in_set =
                std::count_if(elements.begin(), elements.end(), [](const FileElement* e) { return e->n_corners > 2; });
            std::smatch match;
            const bool is_prefixed = std::regex_search(set, match, prefix, std::regex_constants::match_continuous);
            const std::string name = is_prefixed ? match.suffix().str() : set;
            if (n_in_set > 0 && std::regex_match(set, match, grain)) {
                const std::int64_t number = std::stoll(match[2].str());
                for (FileElement* element : elements) {
                    if (element->n_corners > 2) element->entity = number;
                }
                mesh_.entity_names[number] = set;
            } else if (n_in_set > 0 && (is_prefixed || n_in_set < n_surfaces)) {
                mesh_.surface_names[++physical] = name;
                give(elements, physical, false);
            } else if (n_in_set == 0 && !elements.empty() && !std::regex_match(set, line)) {
                mesh_.line_names[++physical] = name;
                give(elements, physical, true);
            }
        }
    }

    void give(const std::vector<FileElement*>& elements, std::int64_t physical, bool is_line) {
        for (FileElement* element : elements) {
            if ((element->n_corners == 2) != is_line) continue;
            if (element->physical > 0 && !is_line) {
                throw InputError(fmt::format(
                    "{}: element {} is in the elsets {} and {}; which of them is its phase is not clear, rename the "
                    "others",
                    name_, element->number, shown(mesh_.surface_names[element->physical]), shown(mesh_.surface_names[physical])));
            }
            element->physical = physical;
        }
    }

    std::string_view bytes_;
    const std::string& name_;
    std::size_t line_ = 0;
    std::string keyword_;
    std::string set_;  ///< of the keyword
    bool is_generated_ = false;
    const AbaqusElement* type_ = nullptr;
    std::vector<std::string_view> element_fields_;  ///< of an element that is not complete
    std::map<std::string, int> parts_;
    std::map<std::string, std::vector<std::int64_t>> sets_;
    std::vector<std::string> set_order_;
    std::unordered_map<std::int64_t, std::size_t> index_;
    FileMesh mesh_;
};

}  // namespace

bool is_abaqus(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    const std::string begin = upper(bytes.substr(first, 10));
    for (const std::string_view known : {"**", "*HEADING", "*NODE", "*PART", "*PREPRINT", "*PARAMETER"}) {
        if (begin.substr(0, known.size()) == known && begin.substr(0, 3) != "***") return true;
    }
    return false;
}

FileMesh read_abaqus(std::string_view bytes, const std::string& name) { return AbaqusReader(bytes, name).read(); }

}  // namespace graincrack::mesher
