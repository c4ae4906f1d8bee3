#include "mesher/import/mesh_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t longest_shown = 40;
constexpr std::string_view white_space = " \t\r\n\f\v";

std::string shown(std::string_view text) { return printable(std::string(text.substr(0, longest_shown))); }

template <typename T>
bool parse(std::string_view text, T& value) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc{} && result.ptr == text.data() + text.size();
}

}  // namespace

void MeshText::skip_white_space() {
    while (place_ < bytes_.size() && white_space.find(bytes_[place_]) != std::string_view::npos) {
        if (bytes_[place_++] == '\n') ++line_;
    }
}

bool MeshText::at_end() {
    skip_white_space();
    return place_ == bytes_.size();
}

std::string_view MeshText::line() {
    const std::size_t end = std::min(bytes_.find('\n', place_), bytes_.size());
    std::string_view text = bytes_.substr(place_, end - place_);
    place_ = std::min(end + 1, bytes_.size());
    ++line_;
    const std::size_t first = text.find_first_not_of(white_space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(white_space) + 1 - first);
}

std::string_view MeshText::word(const char* what) {
    skip_white_space();
    if (place_ == bytes_.size()) fail(fmt::format("the file ends where {} is expected", what));
    const std::size_t end = std::min(bytes_.find_first_of(white_space, place_), bytes_.size());
    const std::string_view text = bytes_.substr(place_, end - place_);
    place_ = end;
    return text;
}

std::int64_t MeshText::integer(const char* what) {
    const std::string_view text = word(what);
    std::int64_t value = 0;
    if (!parse(text, value)) fail(fmt::format("\"{}\" stands where {} is expected, an integer", shown(text), what));
    return value;
}

double MeshText::number(const char* what) {
    const std::string_view text = word(what);
    double value = 0;
    if (!parse(text, value) || !std::isfinite(value)) {
        fail(fmt::format("\"{}\" stands where {} is expected, a number", shown(text), what));
    }
    return value;
}

std::size_t MeshText::count(const char* what, std::size_t bytes_each) {
    const std::int64_t value = integer(what);
    if (value < 0 || static_cast<std::uint64_t>(value) > (bytes_.size() - place_) / bytes_each) {
        fail(fmt::format("{} is {}, for which the file is too short", what, value));
    }
    return static_cast<std::size_t>(value);
}

std::string MeshText::quoted(const char* what) {
    skip_white_space();
    const std::size_t end = place_ < bytes_.size() && bytes_[place_] == '"' ? bytes_.find('"', place_ + 1) : std::string::npos;
    if (end == std::string_view::npos) fail(fmt::format("{} is expected, between double quotes", what));
    std::string text(bytes_.substr(place_ + 1, end - place_ - 1));
    place_ = end + 1;
    return text;
}

bool MeshText::skip_to(std::string_view text) {
    while (place_ < bytes_.size()) {
        if (line() == text) return true;
    }
    return false;
}

void MeshText::fail(const std::string& message) const { throw InputError(fmt::format("{}: line {}: {}", name_, line_, message)); }

}  // namespace graincrack::mesher
