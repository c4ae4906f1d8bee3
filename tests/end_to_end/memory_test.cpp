// Commands read a run array by array: beside what the libraries take themselves, no more memory than twice the file, and twice
// the picture that they write.
#include <filesystem>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

/// Largest resident memory of a call of the tool, bytes.
double memory_of(const Shell& shell, const std::string& call) {
    return 1024 * std::stod(shell.must("/usr/bin/python3 -c 'import resource, subprocess, sys; subprocess.run(sys.argv[1:], "
                                       "check=True, stdout=subprocess.DEVNULL); "
                                       "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' graincrack-post " +
                                       call));
}

TEST(Memory, IsAtMostTwiceTheFile) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
    GTEST_SKIP() << "a sanitized program takes a multiple of it";
#endif
#endif
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 80mm --height 160mm --grains 60000 --quiet -o s.h5\n"
        "graincrack-solve uniaxial s.h5 --material augig-granite --rate 100mm/s --max-strain 5e-7 --frames 2 --quiet -o run.h5");
    const auto size = static_cast<double>(std::filesystem::file_size(shell.file("run.h5")));
    EXPECT_GT(size, 20e6);
    const double libraries = memory_of(shell, "plot lennard-jones -o potential.svg");  // with the fonts
    for (const std::string call :
         {"strength run.h5", "moduli run.h5", "history run.h5", "info run.h5 --check", "cracks run.h5 --quiet -o cracks",
          "plot cracks run.h5 -o cracks.svg", "plot fragments run.h5 -o fragments.svg"}) {
        const double memory = memory_of(shell, call) - libraries;
        // Cairo and its writer hold an SVG as text, once each, until it is whole.
        const std::string output = call.substr(call.rfind(' ') + 1);
        const double picture = output.ends_with(".svg") ? static_cast<double>(std::filesystem::file_size(shell.file(output))) : 0;
        EXPECT_LE(memory, 2 * size + 2 * picture) << call;
    }
}

}  // namespace
}  // namespace graincrack::test
