// Calibration parameters: what a calibration may change of a material, each with its box, first guess and source.
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

/// A coordinate for each parameter, 0 in the middle and ±1 at the edges of the first box, so that coordinates stay the same when
/// a box moves or becomes smaller.
using DesignPoint = Eigen::VectorXd;

struct Box {
    DesignPoint centre;
    DesignPoint half;  ///< of the widths

    [[nodiscard]] Eigen::Index size() const { return centre.size(); }
    /// Coordinates that are ±1 at the edges of this box.
    [[nodiscard]] DesignPoint local(const DesignPoint& point) const { return (point - centre).cwiseQuotient(half); }
    [[nodiscard]] bool contains(const DesignPoint& point) const { return local(point).lpNorm<Eigen::Infinity>() <= 1 + 1e-9; }
    [[nodiscard]] DesignPoint nearest(const DesignPoint& point) const {
        return point.cwiseMax(centre - half).cwiseMin(centre + half);
    }
    /// The box about another centre, so many times as wide, moved or cut where it would leave the limits.
    [[nodiscard]] Box about(const DesignPoint& at, double times, const Box& limits) const;
};

/// The box that both corners span.
Box box_between(const DesignPoint& low, const DesignPoint& high);
/// The smallest box that holds two boxes.
Box hull(const Box& a, const Box& b);

/// Points first, first + 1, … of the sequence of Sobol' in a box. They fill it evenly, however many there are.
/// \pre at most 40 parameters
std::vector<DesignPoint> sobol_points(const Box& box, std::size_t first, std::size_t n);

/// Values of parameters by their keys of a material file, "contact.cohesion", SI.
using Point = std::vector<std::pair<std::string, double>>;

struct Parameter {
    std::string key;
    bool logarithmic = true;
    double low = 0;  ///< edges of the first box, SI
    double high = 0;
    double least = 0;  ///< limits of boxes that move
    double most = 0;
    double first = 0;         ///< guess
    std::string source = {};  ///< of first guess and box, in words

    [[nodiscard]] double coordinate(double value) const;
    [[nodiscard]] double value(double coordinate) const;
    /// d coordinate / d ln value.
    [[nodiscard]] double coordinate_by_log(double value) const;
};

/// The rows of [parameters]; without that table those that the law of the material has by default. Crystals that break whose
/// cohesion is by [ratios] have that ratio instead of the cohesion. A key of a material that has no default box needs low and
/// high. \param edge mean grain edge, m
/// \throws InputError naming file and key of what is wrong
std::vector<Parameter> parameters_of(const Material& rock, const TomlFile& file, double edge);

/// The limits of all boxes, the first guess, and the values at a design point.
Box limits_of(const std::vector<Parameter>& parameters);
DesignPoint first_guess(const std::vector<Parameter>& parameters);
Point point_at(const std::vector<Parameter>& parameters, const DesignPoint& at);

/// The unit in which files and reports show the values of a key, and its value in SI.
struct DisplayUnit {
    const char* symbol;
    double si;
};
DisplayUnit display_unit(const std::string& key);
/// A value in that unit, to six digits: "38.2MPa", "38.2 MPa" with a space between.
std::string value_text(const std::string& key, double value, const char* between = "");
/// A value in that unit, and the name of its column in tables: "contact.cohesion_MPa".
double in_unit(const std::string& key, double value);
std::string column_of(const std::string& key);
/// The settings of a material file for a point.
std::vector<MaterialSetting> settings_of(const Point& point);
/// "contact.cohesion 38.2 MPa, …"
std::string label_of(const Point& point);

}  // namespace graincrack::calibrate
