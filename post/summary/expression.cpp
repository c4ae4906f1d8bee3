#include "post/summary/expression.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "post/table/condition.hpp"
#include "share/base/error.hpp"
#include "share/base/printable.hpp"

namespace graincrack::summary {

namespace {

/// Of one row, or of the rows of a group.
template <class Argument>
using Expression = std::function<Number(const Argument&)>;
using Row = std::size_t;
using Group = std::vector<std::size_t>;

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_name(char c) { return begins_name(c) || std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.'; }

Number calculate(char sign, double a, double b) {
    switch (sign) {
        case '+': return a + b;
        case '-': return a - b;
        case '*': return a * b;
        default: return b == 0 ? std::nullopt : Number(a / b);
    }
}

template <class Argument>
Expression<Argument> combine(char sign, Expression<Argument> a, Expression<Argument> b) {
    return [sign, a = std::move(a), b = std::move(b)](const Argument& argument) -> Number {
        const Number first = a(argument);
        if (sign == '|') return first ? first : b(argument);
        const Number second = b(argument);
        if (!first || !second) return std::nullopt;
        return calculate(sign, *first, *second);
    };
}

constexpr std::size_t max_atoms = 1000;  // of an expression; each nests a function in another

class Parser {
public:
    Parser(const std::string& text, const JoinedRows& rows) : text_(text), rows_(&rows) {}
    template <class Argument>
    Expression<Argument> whole() {
        Expression<Argument> expression = sum<Argument>();
        if (next() != '\0') fail("the end or an operator is needed");
        return expression;
    }

private:
    [[noreturn]] void fail(const std::string& needed) const {
        constexpr std::size_t shown = 200;  // bytes of the text
        throw UsageError(fmt::format("{}: at \"{}\": {}", shortened(text_, shown),
                                     shortened(text_.substr(std::min(at_, text_.size())), shown), needed));
    }
    char next() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (next() != c) return false;
        ++at_;
        return true;
    }
    void need(char c) {
        if (!take(c)) fail(fmt::format("{} is needed", c));
    }
    std::string name() {
        if (!begins_name(next())) fail("a number, a name or ( is needed");
        const std::size_t from = at_;
        while (at_ < text_.size() && in_name(text_[at_])) ++at_;
        return text_.substr(from, at_ - from);
    }
    bool take_word(const std::string& word) {
        next();
        if (text_.compare(at_, word.size() + 1, word + " ") != 0) return false;
        at_ += word.size();
        return true;
    }

    template <class Argument, class Part>
    Expression<Argument> chain(const std::string& signs, Part part) {
        Expression<Argument> expression = part();
        while (next() != '\0' && signs.find(next()) != std::string::npos) {
            const char sign = text_[at_++];
            expression = combine<Argument>(sign, std::move(expression), part());
        }
        return expression;
    }
    template <class Argument>
    Expression<Argument> sum() {
        return chain<Argument>("+-", [this] { return product<Argument>(); });
    }
    template <class Argument>
    Expression<Argument> product() {
        return chain<Argument>("*/", [this] { return chain<Argument>("|", [this] { return atom<Argument>(); }); });
    }
    template <class Argument>
    Expression<Argument> atom() {
        if (++atoms_ > max_atoms) fail(fmt::format("more than {} numbers, columns and parentheses", max_atoms));
        if (take('(')) {
            Expression<Argument> inner = sum<Argument>();
            need(')');
            return inner;
        }
        if (take('-')) {
            return combine<Argument>(
                '*', [](const Argument&) { return Number(-1); }, atom<Argument>());
        }
        if (next() == 'a' && text_.compare(at_, 4, "abs(") == 0) {
            at_ += 3;
            return [inner = atom<Argument>()](const Argument& argument) -> Number {
                const Number value = inner(argument);
                return value ? Number(std::abs(*value)) : std::nullopt;
            };
        }
        double value = 0;
        next();
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error == std::errc{} && !begins_name(next())) {
            at_ = static_cast<std::size_t>(end - text_.data());
            return [value](const Argument&) { return Number(value); };
        }
        if constexpr (std::is_same_v<Argument, Row>) {
            return column();
        } else {
            return statistic();
        }
    }

    /// Only a column by itself may hold texts: they are counted, and have no value.
    Expression<Row> column() {
        const std::string name = this->name();
        const std::vector<std::string>* const entries = &rows_->column(name);
        return [entries, name](Row row) -> Number {
            const std::string& entry = (*entries)[row];
            if (entry.empty()) return std::nullopt;
            if (const auto number = parse_number(entry)) return number;
            throw InputError(fmt::format("{}: \"{}\" in row {}; a number is needed", name, entry, row + 1));
        };
    }
    /// `n` of a column by itself: its texts count too.
    Expression<Row> presence() {
        const std::size_t from = at_;
        const std::string name = begins_name(next()) ? this->name() : "";
        if (!name.empty() && (next() == ')' || text_.compare(at_, 6, "where ") == 0)) {
            const std::vector<std::string>* const entries = &rows_->column(name);
            return [entries](Row row) { return (*entries)[row].empty() ? std::nullopt : Number(1); };
        }
        at_ = from;
        return sum<Row>();
    }
    Expression<Group> statistic() {
        const std::size_t from = at_;
        const std::string name = this->name();
        const Statistic* const statistic = find_statistic(name);
        if (statistic == nullptr || next() != '(') {
            at_ = from;
            fail(fmt::format("a statistic of columns is needed: one of {}, as in mean(COLUMN)", statistic_names()));
        }
        need('(');
        std::vector<Expression<Row>> columns{name == "n" ? presence() : sum<Row>()};
        while (columns.size() < statistic->columns) {
            need(',');
            columns.push_back(sum<Row>());
        }
        std::vector<Condition> conditions;
        if (take_word("where")) {
            do conditions.push_back(condition());
            while (take_word("and"));
        }
        need(')');
        return evaluate(*statistic, std::move(columns), std::move(conditions));
    }
    Condition condition() {
        next();
        const std::size_t end = std::min(text_.find(')', at_), text_.find(" and ", at_));
        const auto condition = parse_condition(text_.substr(at_, end == std::string::npos ? end : end - at_));
        if (!condition) fail(condition_form);
        static_cast<void>(rows_->column(condition->column));  // there must be one
        at_ = std::min(end, text_.size());
        return *condition;
    }
    Expression<Group> evaluate(const Statistic& statistic, std::vector<Expression<Row>> columns,
                               std::vector<Condition> conditions) const {
        return [&statistic, columns = std::move(columns), conditions = std::move(conditions), rows = rows_](const Group& group) {
            std::vector<std::vector<Number>> values(columns.size());
            for (const Row row : group) {
                bool all = true;
                for (const Condition& condition : conditions) all = all && meets(condition, rows->column(condition.column)[row]);
                for (std::size_t i = 0; all && i < columns.size(); ++i) values[i].push_back(columns[i](row));
            }
            const Number number = statistic.of(values);
            return number && std::isfinite(*number) ? number : std::nullopt;
        };
    }

    std::string text_;
    const JoinedRows* rows_;
    std::size_t at_ = 0;
    std::size_t atoms_ = 0;  ///< so far
};

}  // namespace

GroupExpression parse_expression(const std::string& text, const JoinedRows& rows) { return Parser(text, rows).whole<Group>(); }
RowExpression parse_row_expression(const std::string& text, const JoinedRows& rows) { return Parser(text, rows).whole<Row>(); }

}  // namespace graincrack::summary
