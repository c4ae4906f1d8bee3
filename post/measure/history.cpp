#include "post/measure/history.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <thread>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"

namespace graincrack {

namespace {

std::vector<std::string> history_columns(const History& history) {
    std::vector<std::string> columns;
    for (const HistoryDataset& dataset : std::span(history_datasets).first(history.n_columns())) {
        std::string name(dataset.name);
        if (dataset.dimension != Dimension::one) name.append("_").append(si_unit(dataset.dimension));
        columns.push_back(std::move(name));
    }
    return columns;
}

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

HistoryTable::HistoryTable(std::ostream& out, TableFormat format, const History& history)
    : table_(out, history_columns(history), format) {}

void HistoryTable::row(const History& history, std::size_t index) {
    std::vector<Cell> cells;
    for (std::size_t c = 0; c < history.n_columns(); ++c) {
        const double value = history.columns[c][index];
        cells.push_back(c == static_cast<std::size_t>(HistoryColumn::step) ? count_cell(value) : Cell(value));
    }
    table_.row(cells);
}

void write_history(std::ostream& out, const RunReader& run, TableFormat format) {
    const History history = run.history();
    HistoryTable table(out, format, history);
    for (std::size_t i = 0; i < history.size(); ++i) table.row(history, i);
}

void follow_history(std::ostream& out, const std::string& name, TableFormat format, std::chrono::milliseconds pause) {
    const std::string part = name + ".part";
    const auto there = [](const std::string& file) { return std::filesystem::exists(file); };
    if (!there(name) && !there(part)) throw InputError(name + ": no such file, nor " + part + " of a run in progress");
    std::optional<HistoryTable> table;
    std::size_t written = 0;
    const auto write = [&](const History& history) {
        if (!table && history.size() > 0) table.emplace(out, format, history);
        for (; written < history.size(); ++written) table->row(history, written);
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
