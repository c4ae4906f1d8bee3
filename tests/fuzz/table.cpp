// Tables: of finished runs, and any other.
#include <filesystem>

#include "post/calibrate/folder.hpp"
#include "share/base/table_file.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    const std::string folder = fuzz::scratch_file(".d");
    std::filesystem::create_directories(folder);
    const std::string file = folder + "/strength.tsv";
    std::ofstream(file, std::ios::binary) << fuzz::text_of(bytes, size);
    fuzz::one_input([&] {
        const TableFile table(file);
        for (const std::string& column : table.columns()) {
            static_cast<void>(table.texts(column));
            fuzz::one_input([&] { static_cast<void>(table.numbers_or_nan(column)); });
        }
    });
    return fuzz::one_input([&] { calibrate::read_finished(folder); });
}
