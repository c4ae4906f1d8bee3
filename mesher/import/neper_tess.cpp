#include "mesher/import/neper_tess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "mesher/cells/polygon.hpp"
#include "mesher/import/mesh_text.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

class TessReader {
public:
    TessReader(std::string_view bytes, const std::string& name) : text_(bytes, name) {}

    PlaneCells read() {
        if (text_.line() != "***tess") text_.fail("***tess is expected");
        while (true) {
            if (text_.at_end()) text_.fail("the file ends before ***end");
            const std::string_view section = text_.line();
            if (section == "***end") break;
            if (section == "**format") read_format();
            if (section == "**general") read_general();
            if (section == "**cell") read_cells();
            if (section == "**vertex") read_vertices();
            if (section == "**face") read_faces();
            if (section == "**domain" || section == "**periodicity" || section == "**periodic") {
                break;  // nothing follows that is taken
            }
        }
        if (cells_.size() == 0) text_.fail("no cells; **vertex and **face are needed");
        return std::move(cells_);
    }

    [[nodiscard]] const std::vector<std::int64_t>& numbers() const { return numbers_; }
    [[nodiscard]] const std::string& version() const { return version_; }

private:
    void read_format() {
        version_ = text_.word("the version of the format");
        if (version_ != "2.0" && version_ != "3.3" && version_ != "3.4" && version_ != "3.5") {
            text_.fail(fmt::format("the format is {}; 2.0 or 3.3 to 3.5 is needed", version_.substr(0, 20)));
        }
        text_.line();
    }

    void read_general() {
        const std::int64_t dimension = text_.integer("the dimension of the tessellation");
        if (dimension != 2) {
            text_.fail(fmt::format("the tessellation has {} dimensions; 2 are needed (neper -T -dim 2)", dimension));
        }
        text_.line();
    }

    /// The numbers of cells, if they are not 1, 2, ….
    void read_cells() {
        n_cells_ = text_.count("the number of cells", 1);
        text_.line();
        const MeshText before = text_;
        if (!text_.at_end() && text_.line() == "*id") {
            for (std::size_t i = 0; i < n_cells_; ++i) ids_.push_back(text_.integer("the number of a cell"));
            text_.line();
        } else {
            text_ = before;
        }
    }

    void read_vertices() {
        for (std::size_t n = text_.count("the number of vertices", 10); n > 0; --n) {
            const std::int64_t number = text_.integer("the number of a vertex");
            Point p;
            p.x = text_.number("x of a vertex");
            p.y = text_.number("y of a vertex");
            text_.number("z of a vertex");
            text_.integer("the state of a vertex");
            if (!index_.emplace(number, static_cast<int>(cells_.points.size())).second) {
                text_.fail(fmt::format("vertex {} stands twice in the file", number));
            }
            cells_.points.push_back(p);
        }
        text_.line();
    }

    void read_faces() {
        const std::size_t n_faces = text_.count("the number of faces", 30);
        for (std::size_t i = 0; i < n_faces; ++i) {
            const std::int64_t number = text_.integer("the number of a face");
            numbers_.push_back(i < ids_.size() ? ids_[i] : number);
            std::vector<int> loop;
            for (std::size_t n = text_.count("the number of vertices of a face", 2); n > 0; --n) {
                const std::int64_t vertex = text_.integer("a vertex of a face");
                const auto found = index_.find(vertex);
                if (found == index_.end()) {
                    text_.fail(fmt::format("face {} names vertex {}, which is not in the file", number, vertex));
                }
                loop.push_back(found->second);
            }
            for (std::size_t n = text_.count("the number of edges of a face", 2); n > 0; --n) text_.integer("an edge of a face");
            for (int k = 0; k < 4; ++k) text_.number("the plane of a face");
            for (int k = 0; k < 2; ++k) text_.integer("the state of a face");
            for (int k = 0; k < 3; ++k) text_.number("the point of a face");
            add(number, std::move(loop));
        }
        text_.line();
    }

    void add(std::int64_t number, std::vector<int> loop) {
        const auto at = [&](int p) { return cells_.points[static_cast<std::size_t>(p)]; };
        std::vector<int> sorted = loop;
        std::sort(sorted.begin(), sorted.end());
        if (loop.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
            text_.fail(fmt::format("face {} is no polygon of three different vertices or more", number));
        }
        double area = 0;
        for (std::size_t i = 2; i < loop.size(); ++i) area += signed_area(at(loop[0]), at(loop[i - 1]), at(loop[i]));
        if (area < 0) std::reverse(loop.begin(), loop.end());
        cells_.corners.insert(cells_.corners.end(), loop.begin(), loop.end());
        cells_.start.push_back(static_cast<int>(cells_.corners.size()));
    }

    MeshText text_;
    std::string version_;
    std::size_t n_cells_ = 0;
    std::vector<std::int64_t> ids_;
    std::vector<std::int64_t> numbers_;
    std::unordered_map<std::int64_t, int> index_;
    PlaneCells cells_;
};

double default_element(const PlaneCells& cells) {
    const std::vector<double> areas = areas_of(cells);
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
    return side_for_area(area / static_cast<double>(cells.size()));
}

/// Sides of cells with the cells at both of them.
std::vector<RegionEdge> borders_of(const PlaneCells& cells, const std::string& name) {
    std::map<Edge, int> cell_left_of;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto loop = cells.loop(cell);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Edge side{loop[i], loop[(i + 1) % loop.size()]};
            if (!cell_left_of.emplace(side, static_cast<int>(cell)).second) {
                throw InputError(name + ": two cells overlap: both have the same side");
            }
        }
    }
    std::vector<RegionEdge> borders;
    for (const auto& [side, cell] : cell_left_of) {
        const auto other = cell_left_of.find({side[1], side[0]});
        if (other != cell_left_of.end() && side[0] > side[1]) continue;
        borders.push_back({side[0], side[1], cell, other == cell_left_of.end() ? -1 : other->second});
    }
    return borders;
}

}  // namespace

bool is_neper_tess(std::string_view bytes) { return bytes.substr(0, 7) == "***tess"; }

ImportedMesh import_neper_tess(std::string_view bytes, const PhaseKey& key, std::optional<double> element_size,
                               const std::string& name) {
    TessReader reader(bytes, name);
    const PlaneCells cells = reader.read();
    const double element = element_size.value_or(default_element(cells));
    RefinedMesh refined;
    try {
        refined = refined_triangles(cells.points, borders_of(cells, name), {element});
    } catch (const UsageError& error) {
        throw InputError(
            fmt::format("{}: cells overlap, are no simple polygons, or the elements are too many ({})", name, error.what()));
    }
    ImportedMesh mesh;
    mesh.format = "Neper tessellation " + reader.version();
    if (key.is_given()) mesh.phases = key.phases();
    mesh.points = std::move(refined.points);
    mesh.triangles = std::move(refined.triangles);
    mesh.grain_of_triangle = std::move(refined.region_of_triangle);
    for (const std::int64_t number : reader.numbers()) {
        mesh.phase_of_grain.push_back(key.is_given() ? key.phase({std::to_string(number)}) : "");
    }
    return mesh;
}

}  // namespace graincrack::mesher
