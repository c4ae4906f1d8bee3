// Crystals that break are as stiff as their minerals and boundaries say, however many elements they have.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "share/base/table_file.hpp"
#include "tests/end_to_end/shell.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

// 300 crystals of granite's phases between smooth platens: E of the boundaries' length per area and of Hill's mean (1952), to 1
// %. Of six specimens the moduli by platens scattered by 0.2 % and their means were 0.5, 0.1 and −0.2 % off the prediction.
TEST(CrystalModuli, AreThoseOfMineralsAndBoundariesForAnyNumberOfElements) {
    const Shell shell;
    shell.must(
        "graincrack-post material with augig-granite-triangles --set phases.contrast=1 --set platen.friction_angle=0deg "
        ">m.toml");
    std::vector<double> moduli;
    for (const std::string elements : {"8", "16", "32"}) {
        shell.must("rm -f s.h5 r.h5");
        shell.must(
            "graincrack-mesh rectangle --width 40mm --height 80mm --grains 300 --spread 0.3 --tessellation trigon --material "
            "m.toml "
            "--seed 901 --quiet -o s.h5 --elements-per-crystal " +
            elements);
        shell.must("graincrack-solve uniaxial s.h5 --material m.toml --max-strain 0.0008 --rate 20mm/s --quiet -o r.h5 2>log");
        shell.must("graincrack-post moduli r.h5 >moduli.tsv 2>log");
        const TableFile table(shell.file("moduli.tsv"));
        moduli.push_back(table.numbers("platen_young_modulus_GPa").front());
        verify("phases: crystals, E of 300 crystals of " + elements + " elements (GPa)", moduli.back(),
               table.numbers("predicted_young_modulus_GPa").front(), 0.01, "boundaries' length and Hill's mean");
    }
    const auto [least, most] = std::minmax_element(moduli.begin(), moduli.end());
    verify("phases: crystals, largest over least E for 8, 16 and 32 elements", *most / *least, 1, 0.01, "their mineral");
}

}  // namespace
}  // namespace graincrack::test
