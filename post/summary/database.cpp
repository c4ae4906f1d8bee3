#include "post/summary/database.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

#include "post/summary/functions.hpp"
#include "post/table/number.hpp"
#include "share/base/error.hpp"
#include "share/base/table_file.hpp"

namespace graincrack::summary {

namespace {

using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

/// Empty if the text cannot be prepared, or has nothing but comments. \param rest what follows the first statement
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

/// A file as NAME=FILE or FILE.
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

/// Queries read tables, and do nothing else.
int authorize(void* /*unused*/, int action, const char* /*a*/, const char* /*b*/, const char* /*c*/, const char* /*d*/) {
    return action == SQLITE_SELECT || action == SQLITE_READ || action == SQLITE_FUNCTION ? SQLITE_OK : SQLITE_DENY;
}

void execute(sqlite3* database, const std::string& sql, const std::string& file) {
    if (sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
        throw InputError(fmt::format("{}: {}", file, sqlite3_errmsg(database)));
    }
}

/// Makes the table of files that have one name. \return its columns
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
            for (std::size_t i = 0; i < entries.size(); ++i) bind_entry(insert.get(), static_cast<int>(i + 1), entries[i][row]);
            sqlite3_step(insert.get());
            sqlite3_reset(insert.get());
        }
    }
    return columns;
}

/// For messages.
std::string what_there_is(const std::map<std::string, std::vector<std::string>>& tables) {
    std::string text;
    for (const auto& [table, columns] : tables) text += fmt::format("; {} has {}", table, fmt::join(columns, ", "));
    return text;
}

}  // namespace

Database::Database(const std::vector<std::string>& files, const std::string& label) {
    sqlite3* database = nullptr;
    sqlite3_open(":memory:", &database);
    database_.reset(database, sqlite3_close);
    // A name in quotation marks that is no column would be taken as a text.
    sqlite3_db_config(database, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
    constexpr int longest_text = 10'000'000;
    sqlite3_limit(database, SQLITE_LIMIT_LENGTH, longest_text);
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
    if (step == SQLITE_MISMATCH) throw InputError(fmt::format("{}: {}", name, sqlite3_errmsg(database_.get())));
    if (step != SQLITE_DONE) refuse(step == SQLITE_AUTH ? forbidden : sqlite3_errmsg(database_.get()));
    return answer;
}

}  // namespace graincrack::summary
