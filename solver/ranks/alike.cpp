#include "solver/ranks/alike.hpp"

#include <fmt/format.h>

#include <exception>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {
namespace {

constexpr char after_name = '\x1f', after_fact = '\x1e';
constexpr std::string_view failure = "failure";  // name of the fact that a rank has failed

/// Throws a UsageError that says in which fact a rank differs from the first one.
void refuse_difference(const std::string& first, const std::string& other, std::size_t rank) {
    const auto facts = split(first, after_fact);
    const auto others = split(other, after_fact);
    std::size_t at = 0;
    while (facts[at] == others[at]) ++at;
    const auto own = split(facts[at], after_name);
    const auto theirs = split(others[at], after_name);
    const std::string_view name = own[0].empty() ? theirs[0] : own[0];
    const auto value_of = [name](const auto& fact) { return fact[0] == name && !fact[1].empty() ? fact[1] : "not given"; };
    std::string difference = fmt::format("{}: {} on rank 0, {} on rank {}", name, value_of(own), value_of(theirs), rank);
    if (own[0] == failure) difference = fmt::format("{} (on rank 0, and not on rank {})", own[1], rank);
    if (theirs[0] == failure) difference = fmt::format("{} (on rank {}, and not on rank 0)", theirs[1], rank);
    throw UsageError(difference + "; all ranks need the same options, files and environment");
}

}  // namespace

Facts facts_of(const Settings& settings, const std::string& before) {
    constexpr int digits = 15;  // every text of a number keeps these digits
    Facts facts;
    for (const Setting& each : settings) facts.emplace_back(before + option_name(each), shown(each, digits));
    return facts;
}

void prepare_alike(const Ranks& ranks, const std::function<Facts()>& prepare) {
    Facts facts;
    std::exception_ptr error;
    try {
        facts = prepare();
    } catch (const std::exception& cause) {
        error = std::current_exception();
        facts = {{std::string(failure), cause.what()}};
    }
    std::vector<char> own;
    for (const auto& [name, value] : facts) {
        for (const char c : name + after_name + value + after_fact) own.push_back(c);
    }
    const auto all = ranks.gather_all(own);
    for (std::size_t rank = 1; rank < all.size(); ++rank) {
        if (all[rank] == all.front()) continue;
        refuse_difference({all.front().begin(), all.front().end()}, {all[rank].begin(), all[rank].end()}, rank);
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace graincrack
