// Pictures of labels: PNG, or integers as text. The first byte chooses how they are divided.
#include "mesher/import/labels.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    if (size == 0) return 0;
    mesher::LabelOptions options;
    options.pixel_size = 1e-5;
    options.smallest_piece = 1 + bytes[0] % 8;
    const std::string text = fuzz::text_of(bytes + 1, size - 1);
    static_cast<void>(mesher::looks_like_labels(text));
    return fuzz::one_input([&] { mesher::import_labels(text, options, "section"); });
}
