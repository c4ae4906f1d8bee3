// Settings: the effective values of the options by which a specimen or a run was made, as files hold them and as programs
// compare them. The group of each says what it is about, and whether results depend on it.
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

/// What a setting is about. Results do not depend on settings of the group `none`; seeds draw another specimen of the same kind.
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

/// Nothing (not given, and without a default), a truth value, a number (SI), a seed, a text, numbers or texts.
using SettingValue =
    std::variant<std::monostate, bool, double, std::uint64_t, std::string, std::vector<double>, std::vector<std::string>>;

/// A setting.
struct Setting {
    std::string name;  ///< of its option with underscores, "elements_per_crystal"
    SettingValue value = {};
    Dimension dimension = Dimension::one;  ///< of numbers
    SettingGroup group = SettingGroup::none;
    friend bool operator==(const Setting&, const Setting&) = default;
};
using Settings = std::vector<Setting>;

/// The setting of a name; nullptr if there is none.
const Setting* find_setting(const Settings& settings, std::string_view name);
/// The number of a setting; NaN if it has none, or is none.
double number_of(const Settings& settings, std::string_view name);
/// The text of a setting; "" if it has none, or is none.
std::string text_of(const Settings& settings, std::string_view name);

/// The name of its option without dashes in front, "elements-per-crystal".
std::string option_name(const Setting& setting);
/// A value as people read it: "4 mm", "voronoi", "none"; of many the first ones. \param digits of numbers
std::string shown(const Setting& setting, int digits = 4);
/// The first setting in which two lists, which must outlive the result, differ in value: that of each list, null where it has
/// none; two nulls if they are the same. Those of `ignored` groups do not count.
std::pair<const Setting*, const Setting*> first_difference(const Settings& a, const Settings& b,
                                                           const std::vector<SettingGroup>& ignored = {SettingGroup::none});

/// Writes the attributes `request` of a group, a JSON object with a member a setting, in SI units, null for what is not given;
/// and `request_fields`, an object with the unit and the group of each.
void write_settings(H5Output& file, const std::string& group, const Settings& settings);
/// Reads them; none if the group has no such attributes, as in files of other programs. \throws InputError for damaged ones
Settings read_settings(const H5Input& file, const std::string& group);

}  // namespace graincrack
