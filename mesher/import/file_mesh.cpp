#include "mesher/import/file_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "share/base/error.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

namespace {

constexpr double off_plane = 1e-9;  ///< deviation of z over the extent: round-off of written numbers
constexpr std::size_t longest_plain_name = 40;

/// Checks that all points of the elements lie in a plane z = constant.
void check_plane(const FileMesh& file, const ImportedMesh& mesh, const std::string& name) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low, extent = 0;
    for (const Triangle& triangle : mesh.triangles) {
        for (const int p : triangle) {
            const auto& q = file.positions[index(p)];
            low = std::min(low, q[2]);
            high = std::max(high, q[2]);
            extent = std::max({extent, std::abs(q[0]), std::abs(q[1])});
        }
    }
    if (high - low > off_plane * extent) {
        throw InputError(fmt::format(
            "{}: z of the triangles' nodes runs from {:.6g} to {:.6g}; a plane mesh, with one z, is needed", name, low, high));
    }
}

/// Names that may identify the phase of a grain, the most specific first.
std::vector<std::string> phase_names_of(const FileMesh& file, const FileElement& element, std::int64_t grain) {
    std::vector<std::string> names;
    if (const auto group = file.group_of_entity.find(element.entity); group != file.group_of_entity.end()) {
        names.push_back(std::to_string(group->second));
        return names;
    }
    if (const auto found = file.surface_names.find(element.physical); found != file.surface_names.end()) {
        names.push_back(found->second);
    }
    if (element.physical > 0) names.push_back(std::to_string(element.physical));
    names.push_back(std::to_string(grain));
    return names;
}

/// The phase of a grain according to the file; "" if it has none.
std::string phase_of_file(const FileMesh& file, const FileElement& element) {
    if (const auto group = file.group_of_entity.find(element.entity); group != file.group_of_entity.end()) {
        return fmt::format("group_{}", group->second);
    }
    const auto found = file.surface_names.find(element.physical);
    if (found != file.surface_names.end()) return plain_name(found->second);
    return element.physical > 0 ? fmt::format("physical_{}", element.physical) : "";
}

/// Takes the triangles and named lines of a file, grain by grain.
class MeshTaker {
public:
    MeshTaker(const FileMesh& file, std::optional<GrainChoice> grains, const PhaseKey& key, const std::string& name)
        : file_(file), key_(key), name_(name) {
        index_.reserve(file.node_numbers.size());
        for (std::size_t i = 0; i < file.node_numbers.size(); ++i) {
            if (!index_.emplace(file.node_numbers[i], static_cast<int>(i)).second) {
                fail(fmt::format("node {} stands twice in the file", file.node_numbers[i]));
            }
        }
        mesh_.format = file.format;
        mesh_.notes = file.notes;
        if (key.is_given()) mesh_.phases = key.phases();
        for (const auto& [number, group] : file.surface_names) mesh_.phases.push_back(plain_name(group));
        for (const auto& p : file.positions) mesh_.points.push_back({p[0], p[1]});
        choose_grains(grains);
        number_grains();
    }

    ImportedMesh take() && {
        for (std::size_t i = 0; i < file_.elements.size(); ++i) {
            const FileElement& element = file_.elements[i];
            if (element.n_corners < 2) continue;
            const std::vector<int> c = corners(element);
            if (element.n_corners > 2) {
                add_surface(element, i, c);
            } else if (const auto named = file_.line_names.find(element.physical); named != file_.line_names.end()) {
                mesh_.lines.push_back({c[0], c[1], plain_name(named->second)});
            }
        }
        check_plane(file_, mesh_, name_);
        if (n_twice_ > 0) mesh_.notes.push_back(fmt::format("{} elements stand in the file again: the first counts", n_twice_));
        if (n_quadrangles_ > 0) {
            mesh_.notes.push_back(fmt::format("{} quadrangles were divided into two triangles each", n_quadrangles_));
        }
        finish_phases();
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw InputError(name_ + ": " + message); }

    [[nodiscard]] int node(const FileElement& element, int k) const {
        const std::int64_t number = element.nodes[index(k)];
        const auto found = index_.find(number);
        if (found == index_.end()) {
            fail(fmt::format("element {} names node {}, which is not in the file", element.number, number));
        }
        return found->second;
    }

    [[nodiscard]] Point at(int node) const {
        const auto& p = file_.positions[index(node)];
        return {p[0], p[1]};
    }

    [[nodiscard]] std::vector<int> corners(const FileElement& element) const {
        std::vector<int> nodes;
        for (int k = 0; k < element.n_corners; ++k) nodes.push_back(node(element, k));
        return nodes;
    }

    /// Divides a quadrangle along the shorter diagonal inside it.
    [[nodiscard]] std::array<Triangle, 2> halves(const FileElement& element, const std::vector<int>& c) const {
        const auto are_inside = [&](const std::array<Triangle, 2>& pair) {
            const auto area = [&](const Triangle& t) { return signed_area(at(t[0]), at(t[1]), at(t[2])); };
            return area(pair[0]) * area(pair[1]) > 0;
        };
        std::array<Triangle, 2> first{Triangle{c[0], c[1], c[2]}, Triangle{c[0], c[2], c[3]}};
        std::array<Triangle, 2> other{Triangle{c[0], c[1], c[3]}, Triangle{c[1], c[2], c[3]}};
        if (length(at(c[3]) - at(c[1])) < length(at(c[2]) - at(c[0]))) std::swap(first, other);
        if (are_inside(first)) return first;
        if (!are_inside(other)) fail(fmt::format("quadrangle {} has no area or crosses itself", element.number));
        return other;
    }

    void choose_grains(std::optional<GrainChoice> grains) {
        std::set<std::int64_t> entities;
        for (const FileElement& element : file_.elements) {
            if (element.n_corners < 3) continue;
            entities.insert(element.entity);
            has_physical_ = has_physical_ || element.physical > 0;
        }
        if (entities.empty()) {
            fail(fmt::format("no triangles or quadrangles, only {} lines; a plane mesh is needed", file_.elements.size()));
        }
        if (!grains && entities.size() == 1) {
            grains = GrainChoice::element;
            mesh_.notes.emplace_back("all elements are of one entity: each element is a grain (--grain element)");
        }
        choice_ = grains.value_or(GrainChoice::entity);
        if (choice_ == GrainChoice::physical && !has_physical_) {
            fail("--grain physical: physical groups: none; Gmsh's Mesh.SaveAll drops them in MSH 2.2");
        }
    }

    /// Number of the grain of an element in the file.
    [[nodiscard]] std::int64_t grain_of(std::size_t i) const {
        if (choice_ == GrainChoice::element) return static_cast<std::int64_t>(i);
        return choice_ == GrainChoice::entity ? file_.elements[i].entity : file_.elements[i].physical;
    }

    /// Numbers grains in the order of their numbers in the file.
    void number_grains() {
        for (std::size_t i = 0; i < file_.elements.size(); ++i) {
            if (file_.elements[i].n_corners >= 3) number_of_grain_.emplace(grain_of(i), 0);
        }
        int n_grains = 0;
        for (auto& [grain, number] : number_of_grain_) number = n_grains++;
        mesh_.phase_of_grain.resize(number_of_grain_.size());
        first_of_grain_.resize(number_of_grain_.size(), nullptr);
    }

    void add_surface(const FileElement& element, std::size_t i, const std::vector<int>& c) {
        // An element of several physical groups occurs once for each in the file.
        std::array<int, 4> nodes{-1, -1, -1, -1};
        std::copy(c.begin(), c.end(), nodes.begin());
        std::sort(nodes.begin(), nodes.end());
        if (!seen_.insert(nodes).second) {
            ++n_twice_;
            return;
        }
        const int grain = number_of_grain_.at(grain_of(i));
        const FileElement*& first = first_of_grain_[index(grain)];
        if (first == nullptr) {
            first = &element;
            const std::int64_t number = choice_ == GrainChoice::element ? element.number : grain_of(i);
            mesh_.phase_of_grain[index(grain)] =
                key_.is_given() ? key_.phase(phase_names_of(file_, element, number)) : phase_of_file(file_, element);
        } else if (first->physical != element.physical && choice_ == GrainChoice::entity) {
            fail(fmt::format("elements {} and {} of entity {} are of the physical groups {} and {}; a grain is of one phase",
                             first->number, element.number, element.entity, first->physical, element.physical));
        }
        if (element.n_corners == 3) {
            mesh_.triangles.push_back({c[0], c[1], c[2]});
        } else {
            ++n_quadrangles_;
            for (const Triangle& half : halves(element, c)) mesh_.triangles.push_back(half);
        }
        mesh_.grain_of_triangle.resize(mesh_.triangles.size(), grain);
    }

    void finish_phases() {
        const std::set<std::string> phases(mesh_.phase_of_grain.begin(), mesh_.phase_of_grain.end());
        if (phases.size() > max_phases) {
            if (key_.is_given()) fail(fmt::format("{} phases; at most {} fit", phases.size(), max_phases));
            mesh_.notes.emplace_back(
                fmt::format("{} physical groups are more than the {} phases that fit: all grains are \"rock\"; "
                            "--phase-key FILE gives them phases",
                            phases.size(), max_phases),
                "many_groups");
            std::fill(mesh_.phase_of_grain.begin(), mesh_.phase_of_grain.end(), "");
        }
        if (!has_physical_ && file_.group_of_entity.empty() && !key_.is_given() && !file_.without_groups.empty()) {
            mesh_.notes.push_back(file_.without_groups);
        }
    }

    const FileMesh& file_;
    const PhaseKey& key_;
    const std::string& name_;
    std::unordered_map<std::int64_t, int> index_;  ///< index of nodes by number
    ImportedMesh mesh_;
    GrainChoice choice_ = GrainChoice::entity;
    bool has_physical_ = false;
    std::map<std::int64_t, int> number_of_grain_;
    std::vector<const FileElement*> first_of_grain_;
    std::set<std::array<int, 4>> seen_;  ///< corners of elements
    std::size_t n_twice_ = 0, n_quadrangles_ = 0;
};

}  // namespace

std::string plain_name(const std::string& name) {
    std::string plain;
    for (const char c : name.substr(0, longest_plain_name)) {
        const auto byte = static_cast<unsigned char>(c);
        plain += byte < 128 && (std::isalnum(byte) != 0 || c == '-') ? static_cast<char>(std::tolower(byte)) : '_';
    }
    return plain;
}

ImportedMesh imported_mesh(const FileMesh& file, std::optional<GrainChoice> grains, const PhaseKey& key,
                           const std::string& name) {
    return MeshTaker(file, grains, key, name).take();
}

}  // namespace graincrack::mesher
