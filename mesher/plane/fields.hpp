// Texts between separators.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace graincrack::mesher {

/// The fields of a text between separators, one more than there are separators.
inline std::vector<std::string_view> fields_of(std::string_view text, char separator = ',') {
    std::vector<std::string_view> fields;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(separator, from), text.size());
        fields.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return fields;
}

/// KEY=VALUE; without an equals sign the value is empty.
struct KeyValue {
    explicit KeyValue(std::string_view field) : text(field), key(field.substr(0, field.find('='))) {
        if (key.size() < field.size()) value = field.substr(key.size() + 1);
    }
    std::string_view text;
    std::string_view key;
    std::string_view value;
};

}  // namespace graincrack::mesher
