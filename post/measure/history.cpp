#include "post/measure/history.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <thread>

#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"

namespace graincrack {

namespace {

std::vector<std::string> history_columns(const History& history) {
    std::vector<std::string> columns;
    for (const HistoryDataset& dataset : std::span(history_datasets).first(history.n_columns())) {
        const bool is_pure = dataset.dimension == Dimension::one;
        columns.push_back(script_name(std::string(dataset.name), {is_pure ? "" : si_unit(dataset.dimension)}));
    }
    return columns;
}

/// The table of a history that grows.
class HistoryTable {
public:
    HistoryTable(std::ostream& out, TableFormat format, const History& history) : table_(out, history_columns(history), format) {}
    /// Writes the rows that are new.
    void add(const History& history) {
        for (; written_ < history.size(); ++written_) {
            std::vector<Cell> cells;
            for (std::size_t c = 0; c < history.n_columns(); ++c) {
                const double value = history.columns[c][written_];
                cells.push_back(c == static_cast<std::size_t>(HistoryColumn::step) ? count_cell(value) : Cell(value));
            }
            table_.row(cells);
        }
    }

private:
    TableWriter table_;
    std::size_t written_ = 0;
};

std::vector<char> bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The rows flushed so far; empty if the file is being flushed, or no longer exists. A flush between two reads shows in their
/// difference: one read alone may have half of it.
std::optional<History> peek(const std::string& part) {
    const std::vector<char> image = bytes_of(part);
    if (image.empty() || bytes_of(part) != image) return std::nullopt;
    try {
        return read_history(H5Input::from_image(image, part, "run"));
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}  // namespace

void write_history(std::ostream& out, const RunReader& run, TableFormat format) {
    const History history = run.history();
    HistoryTable(out, format, history).add(history);
}

void follow_history(std::ostream& out, const std::string& name, TableFormat format, std::chrono::milliseconds pause) {
    const std::string part = name + ".part";
    const auto there = [](const std::string& file) { return std::filesystem::exists(file); };
    if (!there(name) && !there(part)) throw InputError(name + ": no such file, nor " + part + " of a run in progress");
    std::optional<HistoryTable> table;
    const auto write = [&](const History& history) {
        if (!table && history.size() > 0) table.emplace(out, format, history);
        if (table) table->add(history);
        out.flush();
    };
    // A file NAME beside NAME.part is an older run that is about to be replaced: NAME.part is read first.
    while (there(part)) {
        if (const std::optional<History> history = peek(part)) write(*history);
        throw_if_interrupted();
        if (!out) return;
        std::this_thread::sleep_for(pause);
    }
    if (!there(name)) throw InputError(name + ": the run was abandoned; " + part + " was removed without a result");
    write(RunReader(name).history());
}

}  // namespace graincrack
