#include "share/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

/// Edits (insert, remove, replace) that turn one word into the other.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

}  // namespace

std::pair<std::string, std::string> key_and_value(std::string_view text, std::string_view option, std::string_view form) {
    auto sides = sides_of_equals(text);
    if (sides.first.empty() || sides.first.size() == text.size()) {
        throw UsageError(fmt::format("{} {}: {} is needed", option, text, form));
    }
    return sides;
}

std::string text_of_file(const std::string& file, const std::string& needed) {
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::string text;
    for (std::array<char, 4096> bytes{}; stream;) {
        stream.read(bytes.data(), bytes.size());
        text.append(bytes.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (!stream.eof()) throw InputError(fmt::format("{}: cannot be read: {}{}", file, std::strerror(errno), needed));
    return text;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    std::string nearest;
    std::size_t least = (word.size() < 4 ? 1 : std::max<std::size_t>(word.size() / 3, 2)) +
                        1;  // one more than the largest distance that counts as near
    for (const std::string& candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest);
}

}  // namespace graincrack
