// The command line of graincrack-solve: a line of the input is an argument.
#include <vector>

#include "solver/solve_options.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace graincrack;
    const std::string text = fuzz::text_of(bytes, size);
    std::vector<std::string> arguments{"graincrack-solve"};
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        arguments.push_back(text.substr(begin, end - begin).c_str());  // an argument ends with its first zero
        begin = end + 1;
    }
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    return fuzz::one_input([&] { read_solve_options(static_cast<int>(arguments.size()), pointers.data()); });
}
