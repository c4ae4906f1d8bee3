// Tables that say which phase is meant by what a file calls its grains.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graincrack::mesher {

inline constexpr const char* phase_to_be_named = "?";  ///< stands in a key for a phase that is not named yet

/// A colour as 65536 red + 256 green + blue, by `#c03020`, or without # if a letter tells it from a number.
std::optional<int> colour_of_text(std::string_view text);
/// "#c03020"
std::string colour_text(int colour);

/// Phases by what a file calls them: names or numbers of physical groups, groups, elsets or labels, or colours.
class PhaseKey {
public:
    /// Of the pixels of pictures.
    struct OfLabels {
        std::map<int, std::string> by_number;
        std::map<int, std::string> by_colour;
    };

    PhaseKey() = default;
    /// A table with the columns `key` and `phase`; a first row with these names allows further columns, which are passed over.
    /// Comments begin with #, unless six hexadecimal digits and the end of the key follow it: that is a colour. Fields may stand
    /// in quotation marks. \throws InputError naming the file and the line
    explicit PhaseKey(const std::string& path);
    [[nodiscard]] bool is_given() const { return !path_.empty(); }
    /// The phase of the first of the names that has one. \throws InputError if there is none, or it is not named yet
    [[nodiscard]] std::string phase(const std::vector<std::string>& names) const;
    /// Those of labels; phases that are not named yet are left out. \throws InputError for a key that is none, or if no phase is
    /// named
    [[nodiscard]] OfLabels of_labels() const;
    /// In the order of the table.
    [[nodiscard]] const std::vector<std::string>& phases() const { return order_; }

private:
    std::string path_;
    std::map<std::string, std::string> phases_;
    std::vector<std::string> order_;
};

}  // namespace graincrack::mesher
