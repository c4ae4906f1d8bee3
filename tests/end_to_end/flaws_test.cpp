// Flaws of a class of their own through the three tools: a specimen, a material with [flaws.NAME], a run, tables and pictures.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Flaws, AClassHasItsParametersCracksAndPictures) {
    const Shell shell;
    shell.must(
        "{ cat " GRAINCRACK_SOURCE
        "/share/materials/augig-granite.toml\n"
        "printf '%s\\n' '[flaws.vein]' 'tensile_strength = \"1 MPa\"' 'cohesion = \"2 MPa\"' 'fracture_energy = \"4 J/m2\"'; } "
        ">rock.toml\n"
        "printf 'x1_mm\\ty1_mm\\tx2_mm\\ty2_mm\\tclass\\n-20\\t-12\\t20\\t12\\tvein\\n' >flaws.tsv\n"
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 3mm --flaws flaws.tsv --quiet -o specimen.h5\n"
        "graincrack-solve uniaxial specimen.h5 --material rock.toml --rate 100mm/s --max-strain 0.002 --quiet -o run.h5\n"
        "graincrack-post plot cracks run.h5 --class vein -o map.svg\n"
        "graincrack-post report run.h5 -o page.html\n"
        "graincrack-post info --check run.h5");
    const std::string classes = shell.must("graincrack-post classes run.h5 --format tsv | grep vein");
    EXPECT_NE(classes.find("\tvein\t"), std::string::npos) << classes;
    EXPECT_GT(std::atoi(shell.must("graincrack-post cracks run.h5 -o cracks --quiet && grep -c vein cracks/cracks.tsv").c_str()),
              5)
        << "the vein fails first";
    EXPECT_NE(content_of(shell.file("map.svg")).find("contacts of vein"), std::string::npos);
    EXPECT_NE(content_of(shell.file("page.html")).find("vein"), std::string::npos);
    const Outcome missing = shell.run("graincrack-solve uniaxial specimen.h5 --material augig-granite --quiet -o other.h5");
    EXPECT_EQ(missing.exit_code, 3);
    EXPECT_EQ(n_lines(missing.err), 1);
    EXPECT_NE(missing.err.find("[flaws.vein]"), std::string::npos) << missing.err;
}

}  // namespace
}  // namespace graincrack::test
