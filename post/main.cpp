// graincrack-post: tables, VTK files and pictures from runs.
//
//     graincrack-post strength uniaxial.h5 brazilian.h5
//     graincrack-post plot cracks uniaxial.h5 --frame peak -o cracks.png
#include <iostream>

#include "post/command_line.hpp"
#include "share/base/error.hpp"

int main(int argc, char** argv) {
    return graincrack::run_tool("graincrack-post", [&] {
        graincrack::catch_stop_signals();
        graincrack::run_command_line(argc, argv, std::cout);
        return 0;
    });
}
