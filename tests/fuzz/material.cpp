// Material files, whole and incomplete, and the tables of a calibration.
#include "share/rock/material.hpp"
#include "post/calibrate/folder.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    const std::string file = fuzz::written(fuzz::text_of(bytes, size), ".toml");
    fuzz::one_input([&] {
        std::vector<std::string> notes;
        rock_of_laboratory(read_incomplete_material(file), notes);
    });
    return fuzz::one_input([&] { calibrate::read_problem(read_material(file)); });
}
