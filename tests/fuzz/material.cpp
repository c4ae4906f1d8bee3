// Material files, whole and incomplete, and the tables of a calibration; and values that are set in them.
#include "share/rock/material.hpp"
#include "post/calibrate/folder.hpp"
#include "share/base/toml_document.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

/// What is set and set back is as before.
void set_and_set_back(const std::string& text) {
    using namespace graincrack;
    for (const TomlEntry& entry : parse_toml(text, "file").entries) {
        TomlDocument::Path key = entry.section;
        key.push_back(entry.key);
        TomlDocument file(text, "file");
        const std::string old = file.value(key).value();
        file.set(key, "1");
        file.set(key, old);
        if (file.text() != text) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    const std::string file = fuzz::written(fuzz::text_of(bytes, size), ".toml");
    fuzz::one_input([&] { set_and_set_back(fuzz::text_of(bytes, size)); });
    fuzz::one_input([&] {
        std::vector<std::string> notes;
        rock_of_laboratory(read_incomplete_material(file), notes);
    });
    return fuzz::one_input([&] { calibrate::read_problem(read_material(file)); });
}
