#include "post/summary/functions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "post/fit/mohr_coulomb.hpp"
#include "post/fit/size_effect.hpp"
#include "post/statistics/linear_model.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::summary {

namespace {

using Number = std::optional<double>;

/// A statistic computes one number from the values of one or two arguments; entries may be empty.
struct Statistic {
    std::size_t arguments = 1;
    std::function<Number(const std::vector<std::vector<Number>>&)> of;
};

using Values = std::vector<double>;

/// A statistic of one argument from its non-empty entries; empty without any.
template <class Function>
Statistic of_one(Function function) {
    return {1, [function](const std::vector<std::vector<Number>>& arguments) -> Number {
                Values values;
                for (const Number& entry : arguments[0]) {
                    if (entry) values.push_back(*entry);
                }
                if (values.empty()) return std::nullopt;
                return function(values);
            }};
}

/// A statistic of pairs without empty entries, with at least two different x.
template <class Function>
Statistic of_pairs(Function function) {
    return {2, [function](const std::vector<std::vector<Number>>& arguments) -> Number {
                Values x;
                Values y;
                for (std::size_t row = 0; row < arguments[0].size(); ++row) {
                    if (!arguments[0][row] || !arguments[1][row]) continue;
                    x.push_back(*arguments[0][row]);
                    y.push_back(*arguments[1][row]);
                }
                if (std::set<double>(x.begin(), x.end()).size() < 2) return std::nullopt;
                return function(x, y);
            }};
}

Number half_interval(const Values& values) {
    const Estimate mean = sample(values).mean;
    return mean.high ? Number(*mean.high - mean.value) : std::nullopt;
}

std::optional<Estimate> intercept(const Values& x, const Values& y) { return fit_line(x, y)->intercept_estimate(); }
std::optional<Estimate> slope(const Values& x, const Values& y) { return fit_line(x, y)->slope_estimate(); }

std::optional<Estimate> exponent(const Values& x, const Values& y) {
    const auto positive = [](double value) { return value > 0; };
    if (!std::all_of(x.begin(), x.end(), positive) || !std::all_of(y.begin(), y.end(), positive)) return std::nullopt;
    return fit_power_law(x, y)->exponent;
}

Number lack_of_fit_p(const Values& x, const Values& y) {
    std::vector<Values> factors;
    for (const double value : x) factors.push_back({value});
    const std::vector<SurfaceTerm> line{{{0}}, {{1}}};
    const auto test = LinearModel::fit(line, std::move(factors), y).value().lack_of_fit();
    return test ? Number(test->p) : std::nullopt;
}

using Fit = std::optional<Estimate> (*)(const Values& x, const Values& y);

/// Adds a fitted value under a name, and the ends of its 95 % interval as NAME_low and NAME_high.
void add_fit(std::map<std::string, Statistic>& all, const std::string& name, Fit fit) {
    const auto part = [fit](auto of) {
        return of_pairs([fit, of](const Values& x, const Values& y) -> Number {
            const std::optional<Estimate> fitted = fit(x, y);
            return fitted ? of(*fitted) : std::nullopt;
        });
    };
    all[name] = part([](const Estimate& e) { return Number(e.value); });
    all[name + "_low"] = part([](const Estimate& e) { return e.low; });
    all[name + "_high"] = part([](const Estimate& e) { return e.high; });
}

/// Statistics by their names in queries.
const std::map<std::string, Statistic>& statistics() {
    static const std::map<std::string, Statistic> all = [] {
        std::map<std::string, Statistic> named{
            {"mean", of_one([](const Values& v) { return Number(sample(v).mean.value); })},
            {"median", of_one([](const Values& v) { return Number(median(v)); })},
            {"deviation", of_one([](const Values& v) { return sample(v).deviation; })},
            {"low", of_one([](const Values& v) { return sample(v).mean.low; })},
            {"high", of_one([](const Values& v) { return sample(v).mean.high; })},
            {"half_interval", of_one(half_interval)},
            {"lack_of_fit", of_pairs(lack_of_fit_p)},
            {"rank_correlation", of_pairs([](const Values& x, const Values& y) { return Number(rank_correlation(x, y)); })},
            {"cohesion", of_pairs([](const Values& x, const Values& y) { return Number(fit_mohr_coulomb(x, y).cohesion); })},
            {"friction_angle", of_pairs([](const Values& x, const Values& y) {
                 return Number(fit_mohr_coulomb(x, y).friction_angle * 180 / std::numbers::pi);
             })}};
        add_fit(named, "intercept", &intercept);
        add_fit(named, "slope", &slope);
        add_fit(named, "exponent", &exponent);
        return named;
    }();
    return all;
}

std::string text_of(sqlite3_value* value) {
    const auto* const bytes = reinterpret_cast<const char*>(sqlite3_value_text(value));
    return bytes == nullptr ? "" : std::string(bytes, static_cast<std::size_t>(sqlite3_value_bytes(value)));
}

Number number_of(sqlite3_value* value) {
    const int type = sqlite3_value_type(value);
    if (type == SQLITE_NULL) return std::nullopt;
    if (type == SQLITE_INTEGER || type == SQLITE_FLOAT) return sqlite3_value_double(value);
    throw InputError(fmt::format("\"{}\"; a number is needed", shortened(text_of(value), 80)));
}

/// A number in a format such as .1f, +.2f or .0e.
std::string formatted(double number, const std::string& format) {
    constexpr std::size_t longest = 5;
    try {
        if (format.size() <= longest) return fmt::format(fmt::runtime("{:" + format + "}"), number == 0 ? 0.0 : number);
    } catch (const fmt::format_error&) {
    }
    throw UsageError(fmt::format("\"{}\" is no format of a number; .1f, +.2f or .0e fits", shortened(format, 80)));
}

/// An entry alone: numbers with seven digits.
std::string plain(sqlite3_value* value) {
    switch (sqlite3_value_type(value)) {
        case SQLITE_INTEGER: return Cell(static_cast<std::int64_t>(sqlite3_value_int64(value))).text();
        case SQLITE_FLOAT: return Cell(sqlite3_value_double(value)).text();
        default: return text_of(value);
    }
}

void give(sqlite3_context* context, const std::optional<std::string>& text) {
    if (text) sqlite3_result_text(context, text->data(), static_cast<int>(text->size()), SQLITE_TRANSIENT);
}

/// Runs a body and turns its exceptions into error codes, because SQLite is C.
template <class Body>
void guarded(sqlite3_context* context, const Body& body) {
    try {
        body();
    } catch (const UsageError& error) {
        sqlite3_result_error(context, error.what(), -1);
    } catch (const InputError& error) {
        sqlite3_result_error(context, error.what(), -1);
        sqlite3_result_error_code(context, SQLITE_MISMATCH);
    } catch (const std::bad_alloc&) {
        sqlite3_result_error_nomem(context);
    }
}

/// An aggregate that collects values in a `State`, created at the first row. `step` takes the arguments of a row.
template <class State>
struct Gathered {
    static State* of(sqlite3_context* context, bool make) {
        auto** const place = static_cast<State**>(sqlite3_aggregate_context(context, make ? sizeof(State*) : 0));
        if (place == nullptr) return nullptr;
        if (*place == nullptr && make) *place = new State;
        return *place;
    }
    static void step(sqlite3_context* context, int n, sqlite3_value** arguments) {
        guarded(context, [&] { of(context, true)->add(n, arguments); });
    }
    static void finish(sqlite3_context* context) {
        const std::unique_ptr<State> state(of(context, false));
        guarded(context, [&] { (state ? *state : State()).give_to(context); });
    }
    static void add_to(sqlite3* database, const std::string& name, int n_arguments, const Statistic* statistic = nullptr) {
        sqlite3_create_function_v2(database, name.c_str(), n_arguments, SQLITE_UTF8 | SQLITE_DETERMINISTIC,
                                   const_cast<Statistic*>(statistic), nullptr, step, finish, nullptr);
    }
};

struct Columns {
    std::vector<std::vector<Number>> columns;
    void add(int n, sqlite3_value** arguments) {
        columns.resize(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) columns[static_cast<std::size_t>(i)].push_back(number_of(arguments[i]));
    }
    void give_to(sqlite3_context* context) const {
        if (columns.empty()) return;
        const Number number = static_cast<const Statistic*>(sqlite3_user_data(context))->of(columns);
        if (number) sqlite3_result_double(context, *number);
    }
};

struct MeanAndHalf {
    std::vector<std::vector<Number>> values{1};
    std::string format;
    void add(int /*n*/, sqlite3_value** arguments) {
        values[0].push_back(number_of(arguments[0]));
        format = text_of(arguments[1]);
    }
    void give_to(sqlite3_context* context) const {
        const Number mean = statistics().at("mean").of(values);
        const Number half = statistics().at("half_interval").of(values);
        const std::string unsigned_format = format.substr(format.starts_with('+') ? 1 : 0);
        give(context, mean ? formatted(*mean, format) + (half ? " ± " + formatted(*half, unsigned_format) : "") : "-");
    }
};

struct Entries {
    std::vector<std::string> entries;
    void add(int /*n*/, sqlite3_value** arguments) {
        const std::string entry = plain(arguments[0]);
        if (!entry.empty() && std::find(entries.begin(), entries.end(), entry) == entries.end()) entries.push_back(entry);
    }
    void give_to(sqlite3_context* context) const {
        if (!entries.empty()) give(context, fmt::format("{}", fmt::join(entries, "; ")));
    }
};

std::optional<std::string> filled(int n, sqlite3_value** arguments) {
    const std::string format = n > 0 ? text_of(arguments[0]) : "";
    std::string text;
    int argument = 1;
    for (std::size_t at = 0; at < format.size(); ++at) {
        if (format[at] != '{') {
            text += format[at];
            continue;
        }
        const std::size_t close = format.find('}', at);
        if (close == std::string::npos || argument == n) {
            throw UsageError(fmt::format("text: {}: {} is needed", shortened(format, 80),
                                         close == std::string::npos ? "}" : "another argument"));
        }
        const std::string inner = format.substr(at + 1, close - at - 1);
        sqlite3_value* const value = arguments[argument++];
        if (sqlite3_value_type(value) == SQLITE_NULL) return std::nullopt;
        text += inner.empty() ? plain(value) : formatted(*number_of(value), inner.substr(inner[0] == ':' ? 1 : 0));
        at = close;
    }
    if (argument < n) throw UsageError(fmt::format("text: {}: {{}} is needed for each argument", shortened(format, 80)));
    return text;
}

}  // namespace

void add_functions(sqlite3* database) {
    for (const auto& [name, statistic] : statistics()) {
        Gathered<Columns>::add_to(database, name, static_cast<int>(statistic.arguments), &statistic);
    }
    Gathered<MeanAndHalf>::add_to(database, "mean_and_half", 2);
    Gathered<Entries>::add_to(database, "entries", 1);
    sqlite3_create_function_v2(
        database, "text", -1, SQLITE_UTF8 | SQLITE_DETERMINISTIC, nullptr,
        [](sqlite3_context* context, int n, sqlite3_value** arguments) {
            guarded(context, [&] { give(context, filled(n, arguments)); });
        },
        nullptr, nullptr, nullptr);
}

}  // namespace graincrack::summary
