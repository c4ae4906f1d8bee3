#include "post/summary/summarize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "post/summary/database.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::summary {

namespace {

std::map<std::string, std::string> settings_of(const SummaryOptions& options) {
    std::map<std::string, std::string> settings;
    for (const std::string& text : options.settings) {
        const auto [name, value] = key_and_value(text, "--set", "NAME=VALUE");
        settings[name] = value;
    }
    return settings;
}

/// The place of an entry, which is added if it is new.
template <class Entry, class Same>
std::size_t place_of(std::vector<Entry>& entries, const Entry& entry, Same same) {
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& other) { return same(other, entry); });
    const auto place = static_cast<std::size_t>(found - entries.begin());
    if (place == entries.size()) entries.push_back(entry);
    return place;
}

Answer pivoted(const Answer& answer) {
    if (answer.columns.size() < 2) {
        throw UsageError("--pivot: the query has one column; a name and a value are its last two columns");
    }
    const std::size_t n_keys = answer.columns.size() - 2;
    std::vector<std::string> names;
    std::vector<std::vector<Cell>> keys;
    std::map<std::pair<std::size_t, std::size_t>, Cell> values;
    const auto same_text = [](const Cell& a, const Cell& b) { return a.text() == b.text(); };
    for (const std::vector<Cell>& row : answer.rows) {
        const std::vector<Cell> key(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(n_keys));
        const std::size_t at = place_of(keys, key, [&](const auto& a, const auto& b) {
            return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_text);
        });
        const std::size_t column = place_of(names, row[n_keys].text(), std::equal_to<>());
        if (!values.emplace(std::pair(at, column), row.back()).second) {
            throw UsageError(fmt::format("--pivot: the query has two rows of {} for the same {}", names[column],
                                         n_keys > 0 ? answer.columns.front() : "row"));
        }
    }
    Answer wide{{answer.columns.begin(), answer.columns.end() - 2}, std::move(keys)};
    wide.columns.insert(wide.columns.end(), names.begin(), names.end());
    for (std::size_t row = 0; row < wide.rows.size(); ++row) {
        for (std::size_t column = 0; column < names.size(); ++column) {
            const auto found = values.find({row, column});
            wide.rows[row].push_back(found == values.end() ? Cell() : found->second);
        }
    }
    return wide;
}

}  // namespace

void write_summary(std::ostream& out, const std::vector<std::string>& files, const SummaryOptions& options) {
    const Database database(files, options.label);
    const bool is_file = options.sql.ends_with(".sql");
    const std::string sql = is_file               ? text_of_file(options.sql)
                            : options.sql.empty() ? fmt::format("SELECT * FROM \"{}\"", database.tables().front())
                                                  : options.sql;
    Answer answer = database.query(sql, is_file ? options.sql : "--sql", settings_of(options));
    if (options.pivot) answer = pivoted(answer);
    TableWriter table(out, answer.columns, options.format);
    for (const std::vector<Cell>& row : answer.rows) table.row(row);
}

}  // namespace graincrack::summary
