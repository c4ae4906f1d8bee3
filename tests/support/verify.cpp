#include "tests/support/verify.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace graincrack::test {
namespace {

/// Errors below this are round-off, which differs between builds; the table does not print them.
constexpr double round_off = 1e-12;

/// A line of the table.
struct Row {
    std::string name, measured, expected, error, tolerance, source;
    double badness = 0;  ///< error over tolerance: above 1 it failed
    int comparisons = 1;
    [[nodiscard]] std::string text() const {
        return fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}", name, measured, expected, error, tolerance, comparisons,
                           badness <= 1 ? "pass" : "FAIL", source);
    }
};

/// Rows of the test that is running; prints and writes them at its end.
class Rows : public testing::EmptyTestEventListener {
public:
    void add(const Row& row) {
        const auto same = std::find_if(rows_.begin(), rows_.end(), [&row](const Row& r) { return r.name == row.name; });
        if (same == rows_.end()) {
            rows_.push_back(row);
            return;
        }
        const int comparisons = same->comparisons + 1;
        if (!(row.badness <= same->badness)) *same = row;
        same->comparisons = comparisons;
    }
    void OnTestEnd(const testing::TestInfo& info) override {
        if (rows_.empty()) return;
        for (const Row& row : rows_) fmt::print("  verified\t{}\n", row.text());
        if (const char* folder = std::getenv("GRAINCRACK_VERIFICATION"); folder != nullptr && *folder != '\0') {
            std::string name = fmt::format("{}.{}", info.test_suite_name(), info.name());
            std::replace(name.begin(), name.end(), '/', '-');  // of a test with a parameter
            std::ofstream file(fmt::format("{}/{}.tsv", folder, name));
            for (const Row& row : rows_) file << row.text() << '\n';
        }
        rows_.clear();
    }

private:
    std::vector<Row> rows_;
};

/// Owned by GoogleTest from the start of the program.
Rows& rows() {
    static Rows* const listener = [] {
        auto* made = new Rows;
        testing::UnitTest::GetInstance()->listeners().Append(made);
        return made;
    }();
    return *listener;
}
[[maybe_unused]] const Rows& registered = rows();

std::string number(double value) { return fmt::format("{:.6g}", value); }

}  // namespace

void verify(const std::string& name, double measured, double expected, double tolerance, const std::string& source, double scale,
            const char* file, int line) {
    const double size = scale == 0 ? std::abs(expected) : std::abs(scale);
    const double error = std::abs(measured - expected) / size;
    const bool exact = error < round_off;
    const double badness = error / tolerance;
    rows().add({name,
                number(exact           ? expected
                       : expected == 0 ? measured / size
                                       : measured),
                number(expected), exact ? "< 1e-12" : fmt::format("{:.1e}", error), number(tolerance), source,
                std::isnan(badness) ? HUGE_VAL : badness});
    if (!(error <= tolerance)) {
        ADD_FAILURE_AT(file, line) << name << ": measured " << measured << ", expected " << expected << " (" << source
                                   << "): off by " << error << ", tolerance " << tolerance;
    }
}

void verify_between(const std::string& name, double measured, double low, double high, const std::string& source,
                    const char* file, int line) {
    const bool open_below = low == -HUGE_VAL;
    const bool open_above = high == HUGE_VAL;
    const std::string bound = open_below   ? fmt::format("<= {}", number(high))
                              : open_above ? fmt::format(">= {}", number(low))
                                           : fmt::format("{} to {}", number(low), number(high));
    // The worst case is the one nearest to a bound.
    const double badness = open_below   ? 1 + (measured - high) / std::max({std::abs(high), std::abs(measured), DBL_MIN})
                           : open_above ? 1 + (low - measured) / std::max({std::abs(low), std::abs(measured), DBL_MIN})
                                        : std::abs(2 * measured - low - high) / (high - low);
    rows().add({name, number(measured), bound, "", "", source, std::isnan(badness) ? HUGE_VAL : badness});
    if (!(measured >= low && measured <= high)) {
        ADD_FAILURE_AT(file, line) << name << ": measured " << measured << ", expected " << bound << " (" << source << ")";
    }
}

void record_curves(const std::string& name, const std::vector<std::pair<std::string, std::vector<double>>>& columns) {
    const char* const folder = std::getenv("GRAINCRACK_VERIFICATION");
    if (folder == nullptr || *folder == '\0') return;
    std::ofstream file(fmt::format("{}/{}.csv", folder, name));
    std::string text;
    const auto add = [&](const std::string& entry, std::size_t column) { text += (column == 0 ? "" : ",") + entry; };
    for (std::size_t c = 0; c < columns.size(); ++c) add(columns[c].first, c);
    for (std::size_t row = 0; row < columns.front().second.size(); ++row) {
        text += '\n';
        for (std::size_t c = 0; c < columns.size(); ++c) add(number(columns[c].second[row]), c);
    }
    file << text << '\n';
}

}  // namespace graincrack::test
