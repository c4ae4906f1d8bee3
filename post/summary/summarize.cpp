#include "post/summary/summarize.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "post/summary/functions.hpp"
#include "post/table/table.hpp"
#include "share/base/error.hpp"
#include "share/base/table_file.hpp"
#include "share/base/text.hpp"

namespace graincrack::summary {

namespace {

using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

/// Prepares a statement; empty for invalid text or comments only. \param rest receives the text after the first statement
Statement prepare(sqlite3* database, const std::string& sql, const char** rest = nullptr) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database, sql.c_str(), static_cast<int>(sql.size()), &statement, rest);
    return {statement, sqlite3_finalize};
}

void bind_entry(sqlite3_stmt* statement, int place, const std::string& entry) {
    if (entry.empty()) {
        sqlite3_bind_null(statement, place);
    } else if (const auto number = parse_number(entry)) {
        sqlite3_bind_double(statement, place, *number);
    } else {
        sqlite3_bind_text(statement, place, entry.data(), static_cast<int>(entry.size()), SQLITE_TRANSIENT);
    }
}

Cell cell_of(sqlite3_stmt* statement, int column) {
    switch (sqlite3_column_type(statement, column)) {
        case SQLITE_NULL: return {};
        case SQLITE_INTEGER: return Cell(static_cast<std::int64_t>(sqlite3_column_int64(statement, column)));
        case SQLITE_FLOAT: return Cell(sqlite3_column_double(statement, column));
        default: break;
    }
    const auto* const bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    return bytes == nullptr ? Cell() : Cell(std::string(bytes));
}

std::string quoted(const std::string& name) {
    std::string text = "\"";
    for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

std::string stem_of(const std::string& file) { return file == "-" ? "stdin" : std::filesystem::path(file).stem().string(); }

struct NamedTable {
    std::string name;
    std::string stem;
    TableFile file;
};

/// Reads NAME=FILE or FILE.
NamedTable read(const std::string& text) {
    const auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    const std::size_t at = std::min(text.find('='), text.size());
    if (at > 0 && at < text.size() && std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), in_name)) {
        const std::string file = text.substr(at + 1);
        return {text.substr(0, at), stem_of(file), TableFile(file)};
    }
    std::string name = stem_of(text);
    std::replace_if(
        name.begin(), name.end(), [&](char c) { return !in_name(c); }, '_');
    return {name, stem_of(text), TableFile(text)};
}

/// Allows queries to read tables only.
int authorize(void* /*unused*/, int action, const char* /*a*/, const char* /*b*/, const char* /*c*/, const char* /*d*/) {
    return action == SQLITE_SELECT || action == SQLITE_READ || action == SQLITE_FUNCTION ? SQLITE_OK : SQLITE_DENY;
}

void execute(sqlite3* database, const std::string& sql, const std::string& file) {
    if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
        throw InputError(fmt::format("{}: {}", file, sqlite3_errmsg(database)));
    }
}

/// Creates the table of the files with one name. \return its columns
std::vector<std::string> load(sqlite3* database, const std::vector<const NamedTable*>& parts, const std::string& label) {
    std::vector<std::string> columns;
    if (!label.empty()) columns.push_back(label);
    for (const NamedTable* part : parts) {
        if (!label.empty() && part->file.has(label)) {
            throw InputError(fmt::format("{}: has a column {}; --label needs the name of a new one", part->file.name(), label));
        }
        const std::vector<std::string>& own = part->file.columns();
        if (std::set<std::string>(own.begin(), own.end()).size() < own.size()) {
            throw InputError(fmt::format("{}: has two columns of one name: {}", part->file.name(), fmt::join(own, ", ")));
        }
        for (const std::string& column : own) {
            if (std::find(columns.begin(), columns.end(), column) == columns.end()) columns.push_back(column);
        }
    }
    std::string declared;
    std::string places;
    for (const std::string& column : columns) {
        declared += (declared.empty() ? "" : ", ") + quoted(column) + " REAL";
        places += places.empty() ? "?" : ", ?";
    }
    const NamedTable& first = *parts.front();
    execute(database, fmt::format("CREATE TABLE {} ({})", quoted(first.name), declared), first.file.name());
    const Statement insert = prepare(database, fmt::format("INSERT INTO {} VALUES ({})", quoted(first.name), places));
    for (const NamedTable* part : parts) {
        std::vector<std::vector<std::string>> entries;
        for (const std::string& column : columns) {
            entries.push_back(part->file.has(column) ? part->file.texts(column)
                                                     : std::vector(part->file.n_rows(), column == label ? part->stem : ""));
        }
        for (std::size_t row = 0; row < part->file.n_rows(); ++row) {
            throw_if_interrupted();
            for (std::size_t i = 0; i < entries.size(); ++i) bind_entry(insert.get(), static_cast<int>(i + 1), entries[i][row]);
            sqlite3_step(insert.get());
            sqlite3_reset(insert.get());
        }
    }
    return columns;
}

/// The tables and columns, for messages.
std::string what_there_is(const std::map<std::string, std::vector<std::string>>& tables) {
    std::string text;
    for (const auto& [table, columns] : tables) text += fmt::format("; {} has {}", table, fmt::join(columns, ", "));
    return text;
}

/// The rows of a query.
struct Answer {
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
};

/// A database with one table per name. Numeric entries are real numbers, empty ones NULL, others texts.
class Database {
public:
    /// \param files NAME=FILE, or FILE, whose stem is the name, with _ for other characters than letters and digits; "-" is
    /// `stdin`.
    /// Files with one name form one table: their rows in sequence, with NULL in columns that only others have.
    /// \param label empty, or a column that is added to every table: the stem of the file of the row
    /// \throws InputError if a file cannot be read, or has a column twice or a column `label`
    Database(const std::vector<std::string>& files, const std::string& label);

    /// Names of the tables, in the order of the files.
    [[nodiscard]] const std::vector<std::string>& tables() const { return tables_; }

    /// \param name of the query, for messages \param settings values of :NAME in it
    /// \throws UsageError for an invalid query, a :NAME without a value or a value without :NAME; InputError for a text in place
    /// of a number
    [[nodiscard]] Answer query(const std::string& sql, const std::string& name,
                               const std::map<std::string, std::string>& settings) const;

private:
    std::shared_ptr<sqlite3> database_;
    std::vector<std::string> tables_;
    std::map<std::string, std::vector<std::string>> columns_;
};

Database::Database(const std::vector<std::string>& files, const std::string& label) {
    sqlite3* database = nullptr;
    sqlite3_open(":memory:", &database);
    database_.reset(database, sqlite3_close);
    // Otherwise a quoted name that is no column would be a text.
    sqlite3_db_config(database, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
    constexpr int longest_text = 10'000'000;
    sqlite3_limit(database, SQLITE_LIMIT_LENGTH, longest_text);
    constexpr int instructions_between = 10'000;
    sqlite3_progress_handler(
        database, instructions_between, [](void*) { return stop_signal(); }, nullptr);
    add_functions(database);
    std::vector<NamedTable> read_files;
    for (const std::string& file : files) read_files.push_back(read(file));
    for (const NamedTable& each : read_files) {
        if (std::find(tables_.begin(), tables_.end(), each.name) != tables_.end()) continue;
        tables_.push_back(each.name);
        std::vector<const NamedTable*> parts;
        for (const NamedTable& other : read_files) {
            if (other.name == each.name) parts.push_back(&other);
        }
        columns_[each.name] = load(database, parts, label);
    }
    sqlite3_set_authorizer(database, authorize, nullptr);
}

Answer Database::query(const std::string& sql, const std::string& name,
                       const std::map<std::string, std::string>& settings) const {
    const auto refuse = [&](const std::string& message) { throw UsageError(fmt::format("{}: {}", name, message)); };
    const char* rest = nullptr;
    const Statement statement = prepare(database_.get(), sql, &rest);
    const int code = sqlite3_errcode(database_.get());
    const std::string message = sqlite3_errmsg(database_.get());
    const char* const forbidden = "not allowed; a query is SELECT or WITH … SELECT, without recursion";
    if (code == SQLITE_AUTH) refuse(forbidden);
    if (code != SQLITE_OK) refuse(message + (message.starts_with("no such") ? what_there_is(columns_) : ""));
    if (!statement) refuse("no query; SELECT … FROM " + tables_.front() + " is one");
    if (prepare(database_.get(), rest) || sqlite3_errcode(database_.get()) != SQLITE_OK) {
        refuse("more than one query; one is needed");
    }
    std::set<std::string> unused;
    for (const auto& [key, value] : settings) unused.insert(key);
    for (int i = 1; i <= sqlite3_bind_parameter_count(statement.get()); ++i) {
        const char* const parameter = sqlite3_bind_parameter_name(statement.get(), i);
        const std::string key = parameter == nullptr ? "" : parameter + 1;
        const auto found = settings.find(key);
        if (found == settings.end()) refuse(fmt::format(":{0} has no value; give it by --set {0}=…", key));
        bind_entry(statement.get(), i, found->second);
        unused.erase(key);
    }
    if (!unused.empty()) refuse(fmt::format("has no :{} that --set could give a value", *unused.begin()));

    Answer answer;
    const int n_columns = sqlite3_column_count(statement.get());
    for (int i = 0; i < n_columns; ++i) answer.columns.emplace_back(sqlite3_column_name(statement.get(), i));
    int step = sqlite3_step(statement.get());
    for (; step == SQLITE_ROW; step = sqlite3_step(statement.get())) {
        std::vector<Cell>& row = answer.rows.emplace_back();
        for (int i = 0; i < n_columns; ++i) row.push_back(cell_of(statement.get(), i));
    }
    throw_if_interrupted();
    if (step == SQLITE_MISMATCH) throw InputError(fmt::format("{}: {}", name, sqlite3_errmsg(database_.get())));
    if (step != SQLITE_DONE) refuse(step == SQLITE_AUTH ? forbidden : sqlite3_errmsg(database_.get()));
    return answer;
}

std::map<std::string, std::string> settings_of(const SummaryOptions& options) {
    std::map<std::string, std::string> settings;
    for (const std::string& text : options.settings) {
        const auto [name, value] = key_and_value(text, "--set", "NAME=VALUE");
        settings[name] = value;
    }
    return settings;
}

/// Index of an entry, which is added if it is new.
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
        throw_if_interrupted();
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

void write_summary(std::ostream& out, const std::vector<std::string>& files, const SummaryOptions& options, TableFormat format) {
    const Database database(files, options.label);
    const bool is_file = options.sql.ends_with(".sql");
    const std::string sql = is_file               ? text_of_file(options.sql)
                            : options.sql.empty() ? fmt::format("SELECT * FROM \"{}\"", database.tables().front())
                                                  : options.sql;
    Answer answer = database.query(sql, is_file ? options.sql : "--sql", settings_of(options));
    if (options.pivot) answer = pivoted(answer);
    TableWriter table(out, answer.columns, format);
    for (const std::vector<Cell>& row : answer.rows) table.row(row);
}

}  // namespace graincrack::summary
