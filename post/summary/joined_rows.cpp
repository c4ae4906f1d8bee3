#include "post/summary/joined_rows.hpp"

#include <fmt/format.h>

#include <utility>

#include "share/base/error.hpp"

namespace graincrack::summary {

JoinedRows::JoinedRows(const std::vector<TableFile>& tables, const Joining& joining) {
    std::map<std::string, std::size_t> place_of;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const TableFile& table = tables[i];
        names_ += (names_.empty() ? "" : ", ") + table.name();
        std::vector<std::size_t> places;
        if (joining.join.empty()) {
            for (std::size_t row = 0; row < table.n_rows(); ++row) places.push_back(size_++);
        } else {
            for (const std::string& entry : table.texts(joining.join)) {
                const auto [found, is_new] = place_of.emplace(entry, size_);
                if (is_new) ++size_;
                places.push_back(found->second);
            }
        }
        add(table, places);
        if (joining.label.empty()) continue;
        if (table.has(joining.label)) {
            throw InputError(
                fmt::format("{}: has a column {}; --label needs the name of a new one", table.name(), joining.label));
        }
        std::vector<std::string>& entries = columns_[joining.label];
        entries.resize(size_);
        for (const std::size_t place : places) {
            if (entries[place].empty()) entries[place] = joining.labels[i];
        }
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

void JoinedRows::look_up(const TableFile& table) {
    const std::vector<std::string>& names = table.columns();
    const std::vector<std::string> keys = table.texts(names.front());
    std::multimap<std::string, std::size_t> partners;
    for (std::size_t row = 0; row < keys.size(); ++row) partners.emplace(keys[row], row);
    // The row from which each new row comes, and its row of the other table.
    constexpr std::size_t none = -1;
    std::vector<std::pair<std::size_t, std::size_t>> sources;
    const std::vector<std::string>& own = column(names.front());
    for (std::size_t row = 0; row < size_; ++row) {
        const auto [from, to] = partners.equal_range(own[row]);
        if (from == to) sources.emplace_back(row, none);
        for (auto partner = from; partner != to; ++partner) sources.emplace_back(row, partner->second);
    }
    for (auto& [name, entries] : columns_) {
        std::vector<std::string> moved;
        for (const auto& [row, partner] : sources) moved.push_back(entries[row]);
        entries = std::move(moved);
    }
    for (std::size_t i = 1; i < names.size(); ++i) {
        if (columns_.count(names[i]) > 0) {
            throw InputError(fmt::format("{}: column {} is in {} too; a column that is looked up needs a name of its own",
                                         table.name(), names[i], names_));
        }
        const std::vector<std::string> values = table.texts(names[i]);
        std::vector<std::string>& entries = columns_[names[i]];
        for (const auto& [row, partner] : sources) entries.push_back(partner == none ? "" : values[partner]);
    }
    size_ = sources.size();
}

const std::vector<std::string>& JoinedRows::column(const std::string& name) const {
    const auto found = columns_.find(name);
    if (found != columns_.end()) return found->second;
    std::string there;
    for (const auto& [column, entries] : columns_) there += (there.empty() ? "" : ", ") + column;
    throw InputError(fmt::format("{}: no column {}; there are {}", names_, name, there));
}

}  // namespace graincrack::summary
