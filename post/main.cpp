// graincrack-post: tables, VTK files and pictures from runs.
//
//     graincrack-post strength uniaxial.h5 brazilian.h5
//     graincrack-post plot cracks uniaxial.h5 --frame peak -o cracks.png
#include <iostream>

#include "post/command_line.hpp"
#include "post/commands/commands.hpp"
#include "share/error.hpp"

int main(int argc, char** argv) {
    return graincrack::run_tool("graincrack-post", [&] {
        graincrack::catch_stop_signals();
        const auto options = graincrack::read_options(argc, argv);
        if (options) graincrack::run_command(*options, std::cout);
        return 0;
    });
}
