#include "post/chart/labels.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace graincrack {

std::string column_label(const std::string& column) {
    static constexpr std::array<std::array<std::string_view, 2>, 13> units{{{"MPa", "MPa"},
                                                                            {"GPa", "GPa"},
                                                                            {"Pa", "Pa"},
                                                                            {"deg", "°"},
                                                                            {"rad", "rad"},
                                                                            {"mm", "mm"},
                                                                            {"m", "m"},
                                                                            {"kN", "kN"},
                                                                            {"J", "J"},
                                                                            {"s", "s"},
                                                                            {"N", "N"},
                                                                            {"ns", "ns"},
                                                                            {"percent", "%"}}};
    std::string label = column;
    std::string unit;
    const std::size_t last = column.rfind('_');
    if (last != std::string::npos) {
        const auto found =
            std::find_if(units.begin(), units.end(), [&](const auto& u) { return u[0] == column.substr(last + 1); });
        if (found != units.end()) {
            label = column.substr(0, last);
            unit = ", " + std::string((*found)[1]);
        }
    }
    std::replace(label.begin(), label.end(), '_', ' ');
    return label + unit;
}

}  // namespace graincrack
