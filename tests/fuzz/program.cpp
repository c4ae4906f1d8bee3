// Loading programs.
#include "solver/program/program_file.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    return fuzz::one_input([&] {
        const Program program = parse_program(fuzz::text_of(bytes, size), "program.toml");
        static_cast<void>(program.why_dynamic());
        static_cast<void>(at_half_the_rate(program).longest_time());
    });
}
