// Minerals through the three tools: a material with phases, its specimen, its run, tables and pictures by class.
#include <gtest/gtest.h>

#include <numeric>
#include <sstream>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Minerals, CracksByClassAddUpToThoseOfTheTest) {
    const Shell shell;
    shell.must(
        "{ sed 's/^tensile_strength = .24.15 MPa./tensile_strength = 24.15e6/' " GRAINCRACK_SOURCE
        "/share/materials/augig-granite.toml\n"
        "printf '%s\\n' '[phases.quartz]' 'fraction = 0.3' 'relative_young_modulus = 1.4' '[phases.feldspar]' 'fraction = 0.6' "
        "'[phases.mica]' 'fraction = 0.1' 'relative_young_modulus = 0.4' '[strength]' 'modulus = 5'; } >rock.toml\n"
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 4mm --material rock.toml --quiet -o specimen.h5\n"
        "graincrack-solve uniaxial specimen.h5 --material rock.toml --rate 400mm/s --max-strain 0.01 --quiet -o run.h5");
    const std::string strength = shell.must("graincrack-post --quiet strength run.h5 --format tsv");
    const auto sum = [&](const std::string& column) {
        return std::atof(
            shell
                .must("graincrack-post classes run.h5 --format tsv | awk -F '\\t' 'NR == 1 { for (i = 1; i <= NF; ++i) "
                      "if ($i == \"" +
                      column + "\") c = i } NR > 1 { sum += $c } END { print sum }'")
                .c_str());
    };
    for (const char* column : {"tensile_cracks", "shear_cracks"}) {
        EXPECT_EQ(sum(column), std::atof(cell(strength, column).c_str())) << column;
    }
    EXPECT_GT(sum("tensile_cracks"), 0);
    EXPECT_NEAR(sum("length_share"), 1, 1e-5);
    shell.must(
        "graincrack-post plot cracks run.h5 --class mica-quartz -o map.svg\n"
        "graincrack-post plot specimen specimen.h5 --colour strength -o specimen.svg");
    EXPECT_NE(content_of(shell.file("map.svg")).find("mica-quartz only"), std::string::npos);
    const Outcome unknown = shell.run("graincrack-post plot rosette run.h5 --class mica-quarz -o rosette.svg");
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_EQ(n_lines(unknown.err), 1);
    EXPECT_NE(unknown.err.find("run.h5 has contacts of feldspar-feldspar, "), std::string::npos) << unknown.err;
    // The strength without a unit is noted by every command that reads the material.
    for (const char* command :
         {"fpz --material rock.toml", "plot law --material rock.toml -o law.svg", "properties run.h5 --material rock.toml",
          "report run.h5 --material rock.toml -o page.html", "plot strength run.h5 --material rock.toml -o strength.svg",
          "material value contact.cohesion rock.toml"}) {
        const std::string call = std::string("graincrack-post ") + command;
        EXPECT_NE(shell.run(call).err.find(": note: rock.toml: line "), std::string::npos) << command << shell.run(call).err;
        EXPECT_EQ(shell.run(call + " --quiet").err.find("note: rock.toml"), std::string::npos) << command;
    }
    // A run whose phases are not as many as those of its specimen.
    const Outcome bad = shell.run(R"(/usr/bin/python3 - <<'END'
import h5py
with h5py.File('run.h5', 'r+') as run:
    for group in ('phases', 'classes'):
        for name in list(run['run'][group]):
            first = run['run'][group][name][:1]
            del run['run'][group][name]
            run['run'][group][name] = first
END
graincrack-post moduli run.h5)");
    EXPECT_EQ(bad.exit_code, 3);
    EXPECT_NE(bad.err.find("run.h5: /run/phases has 1 phases, the specimen has 3"), std::string::npos) << bad.err;
}

}  // namespace
}  // namespace graincrack::test
