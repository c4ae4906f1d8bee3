// Calibration parameters: the values of a material that a calibration may change, each with its box, first guess and source.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "share/base/toml_file.hpp"
#include "share/rock/material.hpp"
#include "share/rock/material_edit.hpp"

namespace graincrack::calibrate {

/// One coordinate per parameter, 0 at the centre and ±1 at the edges of the first box. A box that moves or shrinks keeps them.
using DesignPoint = Eigen::VectorXd;

struct Box {
    DesignPoint centre;
    DesignPoint half;  ///< half of the widths

    [[nodiscard]] Eigen::Index size() const { return centre.size(); }
    /// Coordinates that are ±1 at the edges of this box.
    [[nodiscard]] DesignPoint local(const DesignPoint& point) const { return (point - centre).cwiseQuotient(half); }
    [[nodiscard]] bool contains(const DesignPoint& point) const { return local(point).lpNorm<Eigen::Infinity>() <= 1 + 1e-9; }
    [[nodiscard]] DesignPoint nearest(const DesignPoint& point) const {
        return point.cwiseMax(centre - half).cwiseMin(centre + half);
    }
    /// A box about another centre, `times` as wide, moved or cut where it would leave the limits.
    [[nodiscard]] Box about(const DesignPoint& at, double times, const Box& limits) const;
};

/// The box with these opposite corners.
Box box_between(const DesignPoint& low, const DesignPoint& high);
/// The smallest box that holds two boxes.
Box hull(const Box& a, const Box& b);

/// Points first, first + 1, … of the sequence of Sobol' in a box, which any number of points fill evenly.
/// \pre at most 40 parameters
std::vector<DesignPoint> sobol_points(const Box& box, std::size_t first, std::size_t n);

/// Values of parameters by their keys of a material file, "contact.cohesion", SI.
using Point = std::vector<std::pair<std::string, double>>;

struct Parameter {
    std::string key;
    bool logarithmic = true;
    double low = 0;  ///< edges of the first box, SI
    double high = 0;
    double least = 0;  ///< limits of boxes that move, SI
    double most = 0;
    double first = 0;         ///< first guess, SI
    std::string source = {};  ///< source of first guess and box, in words

    [[nodiscard]] double coordinate(double value) const;
    [[nodiscard]] double value(double coordinate) const;
    /// The derivative d coordinate / d ln value.
    [[nodiscard]] double coordinate_by_log(double value) const;
};

/// Reads the rows of [parameters]; without that table, the default parameters of the material's law. If crystals can break and
/// [ratios] sets their cohesion, its ratio is the parameter instead. A key without a default box needs low and high.
/// \param edge mean grain edge, m \throws InputError that names file and key of what is wrong
std::vector<Parameter> parameters_of(const Material& rock, const TomlFile& file, double edge);

/// The limits of all boxes, the first guess, and the values at a design point (SI).
Box limits_of(const std::vector<Parameter>& parameters);
DesignPoint first_guess(const std::vector<Parameter>& parameters);
Point point_at(const std::vector<Parameter>& parameters, const DesignPoint& at);

/// The unit of a key in files and reports, and its value in SI.
struct DisplayUnit {
    const char* symbol;
    double si;
};
DisplayUnit display_unit(const std::string& key);
/// A value (SI) in that unit, with six digits: "38.2MPa", or "38.2 MPa" with a space between.
std::string value_text(const std::string& key, double value, const char* between = "");
/// A value (SI) as a number in that unit, and the name of its column in tables: "contact.cohesion_MPa".
double in_unit(const std::string& key, double value);
std::string column_of(const std::string& key);
/// The settings of a material file for a point.
std::vector<MaterialSetting> settings_of(const Point& point);
/// A point in words: "contact.cohesion 38.2 MPa, …".
std::string label_of(const Point& point);

}  // namespace graincrack::calibrate
