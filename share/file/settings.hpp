// Settings: the values of the options that made a specimen or a run, as stored in files and compared by programs. The group of a
// setting says what it concerns, and whether results depend on it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "share/base/quantities.hpp"

namespace graincrack {

class H5Input;
class H5Output;

/// Subject of a setting. Results do not depend on settings of the group `none`; seeds give another specimen of the same kind.
/// Cuts are holes, slits, flaws and joints; the fabric is the tessellation, its distributions and the scatter of strengths;
/// loading is friction, damping, masses and program; the end is what ends a test.
enum class SettingGroup : std::uint8_t {
    none,
    seed,
    test,
    pressure,
    heat,
    plane,
    material,
    shape,
    size,
    cuts,
    grain_size,
    fabric,
    loading,
    rate,
    end
};
std::string_view name_of(SettingGroup group);

/// A value: nothing (not given and without a default), truth value, number (SI), seed, text, numbers or texts.
using SettingValue =
    std::variant<std::monostate, bool, double, std::uint64_t, std::string, std::vector<double>, std::vector<std::string>>;

/// A setting, the value of one option.
struct Setting {
    std::string name;  ///< name of its option with underscores, "elements_per_crystal"
    SettingValue value = {};
    Dimension dimension = Dimension::one;  ///< dimension of numbers
    SettingGroup group = SettingGroup::none;
    friend bool operator==(const Setting&, const Setting&) = default;
};
using Settings = std::vector<Setting>;

/// The setting with a name; nullptr if there is none.
const Setting* find_setting(const Settings& settings, std::string_view name);
/// The number of a setting; NaN if there is none.
double number_of(const Settings& settings, std::string_view name);
/// The text of a setting; "" if there is none.
std::string text_of(const Settings& settings, std::string_view name);

/// The name of its option without leading dashes, "elements-per-crystal".
std::string option_name(const Setting& setting);
/// A readable value: "4 mm", "voronoi", "none"; the first ones of many. \param digits significant digits of numbers
std::string shown(const Setting& setting, int digits = 4);
/// The first setting whose value differs between two lists, which must outlive the result: that of each list, null if it is
/// missing; two nulls without a difference. `ignored` groups do not count.
std::pair<const Setting*, const Setting*> first_difference(const Settings& a, const Settings& b,
                                                           const std::vector<SettingGroup>& ignored = {SettingGroup::none});

/// Writes the attributes of a group: `request`, a JSON object with one member per setting in SI units, null if not given; and
/// `request_fields`, an object with the unit and group of each.
void write_settings(H5Output& file, const std::string& group, const Settings& settings);
/// Reads these attributes; empty if the group has none, as in files of other programs. \throws InputError for damaged ones
Settings read_settings(const H5Input& file, const std::string& group);

}  // namespace graincrack
