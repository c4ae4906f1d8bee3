// Meshes of other programs, in every format, up to the specimen.
#include "mesher/import/import_specimen.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    mesher::ImportRequest request;
    request.file = fuzz::written(fuzz::text_of(bytes, size), ".mesh");
    return fuzz::one_input([&] { static_cast<void>(mesher::describe(mesher::import_specimen(request))); });
}
