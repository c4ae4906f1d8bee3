// share/doc/file-format.md agrees with the files that the tools write.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string page_of_format = GRAINCRACK_SOURCE "/share/doc/file-format.md";

TEST(FileFormat, TheReaderOfThePageReadsARun) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + past_peak);
    const std::string text =
        shell.must("sed '1,/^## A reader/d' " + page_of_format +
                   " | sed -n '/^```python/,/^```$/{/^```/d;p}' >reader.py\n/usr/bin/python3 reader.py run.h5");
    EXPECT_EQ(n_lines(text), 3) << text;
    EXPECT_LT(text.find("peak "), text.find("tensile contact points: ")) << text;
    const int points = std::atoi(text.substr(std::min(text.size(), text.find("tensile contact points: ") + 24)).c_str());
    EXPECT_GT(points, 0) << text;
}

TEST(FileFormat, ThePageHasEveryDatasetAsTheFileDescribesItAndNamesEveryAttribute) {
    const Shell shell;
    const std::string material = " --material augig-granite-calibrated ";
    shell.must("graincrack-mesh disc --diameter 20mm --grains 40 --strength-modulus 5 --open-boundaries 10% --quiet -o disc.h5" +
               material + "\ngraincrack-solve brazilian disc.h5 --rate 400mm/s --max-strain 0.0003 --quiet -o run.h5" + material);
    EXPECT_EQ(shell.run("/usr/bin/python3 " GRAINCRACK_SOURCE "/tests/end_to_end/file_format.py run.h5 " + page_of_format).out,
              "");
}

}  // namespace
}  // namespace graincrack::test
