// What `summarize` makes of a table: a query, and the same text as the format of a text in one.
#include "post/summary/database.hpp"
#include "share/base/printable.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    static const std::string file = fuzz::written("A\tB\tkind\n1\t2\tpeak\n-3\t\tdrop\n1e300\t0\tpeak\n", ".tsv");
    static const summary::Database tables({"t=" + file}, "");
    // Messages quote the text as it is; `run_tool` is what makes it one line.
    const std::string text = printable(fuzz::text_of(bytes, size));
    fuzz::one_input([&] { static_cast<void>(tables.query(text, "--sql", {})); });
    return fuzz::one_input([&] {
        static_cast<void>(tables.query("SELECT text(:TEXT, A, B, kind) FROM t", "--sql", {{"TEXT", text}}));
    });
}
