#include "tests/support/rows.hpp"

#include <toml++/toml.h>

namespace graincrack::test {

std::string with_values(std::string text, const std::map<std::string, std::string>& values) {
    for (const auto& [key, value] : values) {
        const std::string mark = "{" + key + "}";
        for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += value.size()) {
            text.replace(at, mark.size(), value);
        }
    }
    return text;
}

std::vector<RefusedText> refused_texts(const std::string& file) {
    const toml::table table = toml::parse_file(GRAINCRACK_SOURCE "/tests/unit/" + file);
    std::map<std::string, std::string> texts;
    if (const toml::table* given = table["texts"].as_table()) {
        for (const auto& [name, text] : *given) {
            texts[std::string(name.str())] = with_values(text.value<std::string>().value(), texts);
        }
    }
    std::vector<RefusedText> rows;
    for (const auto& each : *table["case"].as_array()) {
        const toml::table& row = *each.as_table();
        RefusedText refused{row["requires"].value<std::string>().value(),
                            with_values(row["text"].value<std::string>().value(), texts),
                            {},
                            row["message"].value_or("")};
        if (const auto part = row["says"].value<std::string>()) refused.says.push_back(*part);
        if (const toml::array* parts = row["says"].as_array()) {
            for (const auto& part : *parts) refused.says.push_back(part.value<std::string>().value());
        }
        rows.push_back(refused);
    }
    return rows;
}

}  // namespace graincrack::test
