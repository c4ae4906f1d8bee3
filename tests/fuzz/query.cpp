// What `summarize` makes of a table: a query, and the same text as the format of a text in one.
#include <sstream>

#include "post/summary/summarize.hpp"
#include "share/base/text.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    static const std::string file = fuzz::written("A\tB\tkind\n1\t2\tpeak\n-3\t\tdrop\n1e300\t0\tpeak\n", ".tsv");
    // Messages quote the text as it is; `run_tool` is what makes it one line.
    const std::string text = printable(fuzz::text_of(bytes, size));
    const auto query = [&](const summary::SummaryOptions& options) {
        return fuzz::one_input([&] {
            std::ostringstream out;
            summary::write_summary(out, {"t=" + file}, options);
        });
    };
    query({.sql = text});
    return query({.sql = "SELECT text(:TEXT, A, B, kind) FROM t", .settings = {"TEXT=" + text}});
}
