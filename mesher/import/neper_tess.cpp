#include "mesher/import/neper_tess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "mesher/elements/constrained.hpp"
#include "mesher/import/mesh_text.hpp"
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
            if (cells_.size() == 0) text_.fail("no cells; **vertex and **face are needed");
        }
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

}  // namespace

bool is_neper_tess(std::string_view bytes) { return bytes.substr(0, 7) == "***tess"; }

ImportedMesh import_neper_tess(std::string_view bytes, const PhaseKey& key, const std::string& name) {
    TessReader reader(bytes, name);
    PlaneCells cells = reader.read();
    PlaneMesh plane;
    try {
        plane = constrained_mesh(std::move(cells), Bodies::cells);
    } catch (const UsageError&) {
        throw InputError(name + ": a cell is no simple polygon: its sides cross or touch each other");
    }
    ImportedMesh mesh;
    mesh.format = "Neper tessellation " + reader.version();
    if (key.is_given()) mesh.phases = key.phases();
    mesh.points = std::move(plane.points);
    mesh.triangles = std::move(plane.triangles);
    mesh.grain_of_triangle = std::move(plane.body_of_triangle);
    for (const std::int64_t number : reader.numbers()) {
        mesh.phase_of_grain.push_back(key.is_given() ? key.phase({std::to_string(number)}) : "");
    }
    mesh.notes.emplace_back("cells have no elements of their own: each is divided into triangles between its vertices");
    return mesh;
}

}  // namespace graincrack::mesher
