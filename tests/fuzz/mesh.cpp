// Meshes of other programs, in every format, up to the specimen; of odd sizes with crystals that break.
#include "mesher/import/import_specimen.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    mesher::ImportRequest request;
    request.file = fuzz::written(fuzz::text_of(bytes, size), ".mesh");
    if (size % 2 == 1) request.crystals = mesher::CrystalChoice::breaking;
    return fuzz::one_input([&] { static_cast<void>(mesher::describe(mesher::import_specimen(request, {}, 1))); });
}
