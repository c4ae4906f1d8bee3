#include "post/report/page.hpp"

#include <fmt/format.h>
#include <md4c-html.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>

#include "post/report/html.hpp"
#include "post/table/number.hpp"
#include "post/table/table.hpp"
#include "post/table/table_file.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

namespace fs = std::filesystem;

/// "size-effect.png" as "Size effect".
std::string title_of(const fs::path& file) {
    std::string title = file.stem().string();
    std::replace_if(
        title.begin(), title.end(), [](char c) { return c == '-' || c == '_'; }, ' ');
    if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!(text << stream.rdbuf())) throw InputError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
    return text.str();
}

/// A number of many digits with four; all else as it stands.
std::string shown(const std::string& entry) {
    const bool is_long = entry.size() > 6 && entry.find('.') != std::string::npos;
    const auto number = is_long ? parse_number(entry) : std::nullopt;
    return number ? format_number(*number, 4) : entry;
}

/// The first heading of a text; "" without one.
std::string heading_of(const std::string& markdown) {
    std::istringstream lines(markdown);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t from = line.find_first_not_of("# ");
        if (line.starts_with('#') && from != std::string::npos) return line.substr(from);
    }
    return "";
}

std::string table_of(const fs::path& file) {
    const TableFile table(file.string());
    std::vector<std::string> header = table.columns();
    for (const std::string& name : header) {
        if (std::count(header.begin(), header.end(), name) > 1) {
            throw InputError(fmt::format("{}: column {} is there twice; each needs a name of its own", file.string(), name));
        }
    }
    std::vector<std::vector<std::string>> columns;
    for (const std::string& name : header) columns.push_back(table.texts(name));
    for (std::string& name : header) std::replace(name.begin(), name.end(), '_', ' ');
    std::ostringstream text;
    TableWriter writer(text, header, TableFormat::markdown);
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        std::vector<Cell> cells;
        for (const auto& column : columns) cells.emplace_back(shown(column[row]));
        writer.row(cells);
    }
    return fmt::format("## {}\n\n{}", title_of(file), text.str());
}

std::string component(const fs::path& file) {
    const std::string kind = file.extension().string();
    if (kind == ".md") return text_of(file);
    if (kind == ".tsv") return table_of(file);
    if (kind == ".png" || kind == ".svg") return fmt::format("![{}]({})\n", title_of(file), file.filename().string());
    throw UsageError(
        fmt::format("{}: no component of a page; texts (.md), tables (.tsv) and pictures (.png, .svg) fit", file.string()));
}

}  // namespace

std::string markdown_page(const std::vector<std::string>& files) {
    std::string page;
    for (const std::string& file : files) page += component(file) + "\n";
    return page;
}

std::string html_page(const std::string& markdown) {
    std::string body;
    const auto append = [](const MD_CHAR* text, MD_SIZE size, void* target) {
        static_cast<std::string*>(target)->append(text, size);
    };
    if (md_html(markdown.data(), static_cast<MD_SIZE>(markdown.size()), append, &body, MD_FLAG_TABLES | MD_FLAG_NOHTML, 0) != 0) {
        throw std::bad_alloc();  // the only failure that md4c has
    }
    const std::string heading = heading_of(markdown);
    return html::page(heading.empty() ? "Study" : heading, "<div class=\"study\">\n" + body + "</div>\n");
}

}  // namespace graincrack
