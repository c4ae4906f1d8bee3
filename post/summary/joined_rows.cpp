#include "post/summary/joined_rows.hpp"

#include <fmt/format.h>

#include "share/error.hpp"

namespace graincrack::summary {

JoinedRows::JoinedRows(const std::vector<TableFile>& tables, const std::string& join) {
    std::map<std::string, std::size_t> place_of;
    for (const TableFile& table : tables) {
        names_ += (names_.empty() ? "" : ", ") + table.name();
        std::vector<std::size_t> places;
        if (join.empty()) {
            for (std::size_t row = 0; row < table.n_rows(); ++row) places.push_back(size_++);
        } else {
            for (const std::string& entry : table.texts(join)) {
                const auto [found, is_new] = place_of.emplace(entry, size_);
                if (is_new) ++size_;
                places.push_back(found->second);
            }
        }
        add(table, places);
    }
    for (auto& [name, entries] : columns_) entries.resize(size_);
}

void JoinedRows::add(const TableFile& table, const std::vector<std::size_t>& places) {
    for (const std::string& name : table.columns()) {
        std::vector<std::string>& entries = columns_[name];
        entries.resize(size_);
        const std::vector<std::string> added = table.texts(name);
        for (std::size_t row = 0; row < added.size(); ++row) {
            if (entries[places[row]].empty()) entries[places[row]] = added[row];
        }
    }
}

const std::vector<std::string>& JoinedRows::column(const std::string& name) const {
    const auto found = columns_.find(name);
    if (found != columns_.end()) return found->second;
    std::string there;
    for (const auto& [column, entries] : columns_) there += (there.empty() ? "" : ", ") + column;
    throw InputError(fmt::format("{}: no column {}; there are {}", names_, name, there));
}

}  // namespace graincrack::summary
