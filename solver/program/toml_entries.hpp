// A table of a TOML file that is written key by key. Numbers have all their digits, in SI units.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "share/base/quantities.hpp"

namespace graincrack {

/// As TOML writes what is no whole number.
std::string toml_number(double value);

class TomlEntries {
public:
    void add(const std::string& key, const std::string& value) { entries_.emplace_back(key, value); }  ///< as TOML writes it

    // Rows of `program/keys.hpp`: what is empty is not written.
    static constexpr bool reads = false;
    void given(const std::string& key, const std::string& value);
    void given(const std::string& key, const std::vector<std::string>& value);
    void given(const std::string& key, bool value) { add(key, value ? "true" : "false"); }
    void given(const std::string& key, const Quantity& /*of*/, double value) { add(key, toml_number(value)); }
    void given(const std::string& key, const Quantity& /*of*/, std::int64_t value) { add(key, std::to_string(value)); }
    void given(const std::string& key, const Quantity& of, const std::optional<double>& value, const char* none = nullptr);
    void given(const std::string& key, const Quantity& of, const std::vector<double>& value);
    template <std::size_t N>
    void given(const std::string& key, const Quantity& of, const std::optional<std::array<double, N>>& value,
               const char* /*fits*/) {
        if (value) given(key, of, std::vector<double>(value->begin(), value->end()));
    }
    void choice(const std::string& key, bool value, const std::string& word_of_false, const std::string& word_of_true) {
        given(key, value ? word_of_true : word_of_false);
    }
    template <class Value>
    void needed(const std::string& key, const Value& value, const std::string& /*what*/) {
        given(key, value);
    }
    void needed(const std::string& key, const Quantity& of, double value, const std::string& /*what*/) { given(key, of, value); }

    [[nodiscard]] std::string lines(const std::string& before = "") const;  ///< key = value, each with `before` in front
    [[nodiscard]] std::string inline_table() const;                         ///< { key = value, … }

private:
    std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace graincrack
