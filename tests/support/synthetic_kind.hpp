// A kind of rock whose tests cost nothing: a planted surface with scatter, at design points spread at random.
#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "post/kind/kind_surface.hpp"
#include "share/base/text.hpp"
#include "tests/support/normal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {

struct SyntheticKind {
    double scatter = 0.06;    ///< of ln of single specimens
    double of_gabbro = -0.1;  ///< what its ln differs by

    /// ln of a mean over its unit: curved in ln cohesion, with a product of that and the friction angle.
    [[nodiscard]] double log_of(const std::string& property, const KindCoordinates& at, double pressure) const {
        const double cohesion = std::log(at.cohesion / 5);
        const double angle = at.friction_angle - 0.77;
        const double zone = std::log(at.process_zone / 0.71);
        const double bridges = at.bridging_strength > 0 ? at.bridging_strength * std::log(at.bridging_energy / 2) : 0;
        if (property == "toughness") return -0.8 + 0.5 * zone + 0.2 * bridges;
        if (property == "brazilian") return -0.1 + 0.1 * cohesion + 0.2 * zone + 0.1 * bridges;
        const double confined = property == "first_peak" ? 0.5 + 0.3 * std::log(pressure) : 0;
        return 2.9 + 0.55 * cohesion + 0.7 * angle + 0.1 * cohesion * cohesion + 0.5 * cohesion * angle + confined;
    }
    /// A row of each test at each of the points. \param kind of these rows
    [[nodiscard]] std::vector<KindRow> rows(int points, std::uint32_t seed = 1, const std::string& kind = "granite") const {
        Normal normal(seed);
        std::vector<KindRow> all;
        for (int i = 0; i < points; ++i) {
            const auto between = [&](double low, double high) { return low + (high - low) * normal.uniform(); };
            const auto of_logs = [&](double low, double high) { return std::exp(between(std::log(low), std::log(high))); };
            KindCoordinates at{
                1, 1, of_logs(1.5, 16), between(0.56, 1), between(0.08, 0.56), of_logs(0.35, 1.8), of_logs(30, 250)};
            at.bridging_strength = std::max(0.0, between(-0.27, 0.8));
            at.bridging_energy = at.bridging_strength > 0 ? of_logs(3, 20) : 0;
            for (const char* property : {"uniaxial", "brazilian", "toughness", "first_peak", "first_peak"}) {
                KindRow row{kind, "d" + std::to_string(i), false, at, 0, property};
                if (row.property == "first_peak") row.confining_pressure = of_logs(0.25, 9);
                row.value = std::exp(log_of(property, at, row.confining_pressure) + scatter * normal() +
                                     (kind == "gabbro" ? of_gabbro : 0));
                all.push_back(row);
            }
        }
        return all;
    }
};

/// A table of rows as share/materials/kinds/surface.tsv.
inline void write_kind_rows(const std::string& file, const std::vector<KindRow>& rows) {
    std::ofstream out(file);
    out << "kind\tpoint\trock\tcohesion\tfriction_angle_deg\tresidual_friction_angle_deg\tprocess_zone\tmode_ii_fracture_energy\t"
           "bridging_strength\tbridging_energy\tconfining_pressure\tproperty\tvalue\tspecimens\n";
    constexpr double degree = std::numbers::pi / 180;
    for (const KindRow& row : rows) {
        out << row.kind << '\t' << row.point << '\t' << row.is_rock << '\t' << row.at.cohesion << '\t'
            << row.at.friction_angle / degree << '\t' << row.at.residual_friction_angle / degree << '\t' << row.at.process_zone
            << '\t' << row.at.mode_ii_fracture_energy << '\t' << row.at.bridging_strength << '\t' << row.at.bridging_energy
            << '\t' << row.confining_pressure << '\t' << row.property << '\t' << row.value << '\t' << row.specimens << '\n';
    }
}

/// A calibrated rock without the predictions of its calibration, of which its kind alone says what it has. \return its file
inline std::string rock_by_kind_alone(const TemporaryFolder& folder) {
    std::string text = text_of_file(std::string(GRAINCRACK_SOURCE) + "/share/materials/wausau-granite-calibrated.toml");
    std::ofstream(folder.file("calibrated.toml")) << text.erase(text.find("[predicted]"));
    return folder.file("calibrated.toml");
}

/// A folder of materials with a table of rows, found before that of the installation while it is there.
class KindFolder {
public:
    explicit KindFolder(const std::vector<KindRow>& rows) {
        std::filesystem::create_directory(folder_.file("kinds"));
        write_kind_rows(table(), rows);
        setenv("GRAINCRACK_MATERIALS", folder_.file("").c_str(), 1);
    }
    ~KindFolder() { unsetenv("GRAINCRACK_MATERIALS"); }
    KindFolder(const KindFolder&) = delete;
    KindFolder& operator=(const KindFolder&) = delete;
    [[nodiscard]] std::string table() const { return folder_.file("kinds/surface.tsv"); }

private:
    TemporaryFolder folder_;
};

}  // namespace graincrack::test
