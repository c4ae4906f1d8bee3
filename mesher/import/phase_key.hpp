// Tables of phases by the names of grains in a file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graincrack::mesher {

inline constexpr const char* phase_to_be_named = "?";  ///< marks a phase in a key that is not entered yet

/// A colour as 65536 red + 256 green + blue, from `#c03020`, or without # if a letter distinguishes it from a number.
std::optional<int> colour_of_text(std::string_view text);
/// The text of a colour, "#c03020".
std::string colour_text(int colour);

/// Phases by keys of a file: names or numbers of physical groups, groups, elsets or labels, or colours.
class PhaseKey {
public:
    /// Phases of pixels of pictures.
    struct OfLabels {
        std::map<int, std::string> by_number;
        std::map<int, std::string> by_colour;
    };

    PhaseKey() = default;
    /// Reads a table with the columns `key` and `phase`; a first row with these names allows further columns, which are skipped.
    /// Comments begin with #, except for a colour: six hexadecimal digits and the end of the key. Fields may be in quotation
    /// marks. \throws InputError naming the file and the line
    explicit PhaseKey(const std::string& path);
    [[nodiscard]] bool is_given() const { return !path_.empty(); }
    /// The phase of the first name that has one. \throws InputError if none has, or it is not entered yet
    [[nodiscard]] std::string phase(const std::vector<std::string>& names) const;
    /// The phases of labels without those not entered yet. \throws InputError for an invalid key, or without any phase
    [[nodiscard]] OfLabels of_labels() const;
    /// The phases in the order of the table.
    [[nodiscard]] const std::vector<std::string>& phases() const { return order_; }

private:
    std::string path_;
    std::map<std::string, std::string> phases_;
    std::vector<std::string> order_;
};

}  // namespace graincrack::mesher
