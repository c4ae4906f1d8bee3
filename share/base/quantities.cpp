#include "share/base/quantities.hpp"

#include <stdexcept>

#include "share/base/units.hpp"

namespace graincrack {

std::string column_name(const Quantity& quantity, std::string_view unit) {
    static_cast<void>(in_unit(1, quantity.dimension, unit));  // refuses a unit of another dimension
    std::string name(quantity.name);
    if (unit.empty() || unit == "1") return name;
    name += '_';
    if (unit == "%") return name + "percent";
    for (std::size_t i = 0; i < unit.size(); ++i) {
        if (unit.substr(i) == ".m^0.5") return name + "_sqrt_m";
        if (unit[i] == '/') {
            name += "_per_";
        } else {
            name += unit[i];
        }
    }
    return name;
}

}  // namespace graincrack
