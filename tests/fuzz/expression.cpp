// What `summarize` makes of a table: an expression, and the same text as a template with numbers in it.
#include "post/summary/expression.hpp"
#include "post/summary/text_template.hpp"
#include "share/base/printable.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    static const std::string file = fuzz::written("A\tB\tkind\n1\t2\tpeak\n-3\t\tdrop\n1e300\t0\tpeak\n", ".tsv");
    static const summary::JoinedRows rows({TableFile(file)}, {});
    static const std::vector<std::size_t> group{0, 1, 2};
    // Messages quote the text as it is; `run_tool` is what makes it one line.
    const std::string text = printable(fuzz::text_of(bytes, size));
    fuzz::one_input([&] { static_cast<void>(summary::parse_expression(text, rows)(group)); });
    fuzz::one_input([&] { static_cast<void>(summary::parse_row_expression(text, rows)(1)); });
    return fuzz::one_input([&] { static_cast<void>(summary::parse_template(text, rows)(group)); });
}
