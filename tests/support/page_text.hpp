// What a page of HTML says.
#pragma once

#include <string>

namespace graincrack::test {

/// The part of a page under the heading of an id, up to the next heading of its kind.
inline std::string section_of(const std::string& page, const std::string& id) {
    const std::size_t from = page.find("<h2 id=\"" + id + "\"");
    return from == std::string::npos ? "" : page.substr(from, page.find("<h2", from + 1) - from);
}

/// Without tags, scripts and pictures; " | " ends a cell, and " / " is a new line in one.
inline std::string text_of_page(const std::string& page) {
    std::string text;
    bool is_cell = false;
    for (std::size_t at = 0; at < page.size();) {
        if (page[at] != '<') {
            text += is_cell && page[at] == '\n' ? std::string(" / ") : std::string(1, page[at]);
            ++at;
            continue;
        }
        const std::string tag = page.substr(at + 1, page.find_first_of(" >", at) - at - 1);
        is_cell = tag == "td" || tag == "th";
        if (tag == "/td" || tag == "/th") text += " | ";
        const bool is_code = tag == "script" || tag == "style" || tag == "noscript";
        at = is_code ? page.find("</" + tag, at) : page.find('>', at) + 1;
    }
    return text;
}

}  // namespace graincrack::test
