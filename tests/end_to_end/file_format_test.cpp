// share/doc/file-format.md agrees with the files that the tools write.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string page_of_format = GRAINCRACK_SOURCE "/share/doc/file-format.md";

TEST(FileFormat, TheReaderOfThePageReadsARun) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + past_peak);
    const std::string text = shell.must("sed -n '/^```python/,/^```$/{/^```/d;p}' " + page_of_format +
                                        " >reader.py\n/usr/bin/python3 reader.py run.h5");
    EXPECT_EQ(n_lines(text), 3) << text;
    EXPECT_LT(text.find("peak "), text.find("tensile contact points: ")) << text;
    const int points = std::atoi(text.substr(std::min(text.size(), text.find("tensile contact points: ") + 24)).c_str());
    EXPECT_GT(points, 0) << text;
}

TEST(FileFormat, ThePageNamesEveryPathAndAttribute) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + elastic);
    write_text(shell.file("names.py"), R"(
import h5py
names = set()
def add(path, object):
    if path.startswith('frames/') and not path.startswith('frames/0000'): return
    if not path.startswith('VTKHDF'):
        names.update(part for part in path.split('/') if not part.isdigit())
    if not path.startswith('VTKHDF'): names.update(object.attrs)
with h5py.File('run.h5') as run:
    names.update(run.attrs)
    run.visititems(add)
for name in sorted(names):
    if not name.endswith('_unit'): print(name)
)");
    const std::string text = content_of(page_of_format);
    std::istringstream names(shell.must("/usr/bin/python3 names.py"));
    int n = 0;
    for (std::string name; std::getline(names, name); ++n) {
        EXPECT_TRUE(text.find('`' + name + '`') != std::string::npos || text.find('/' + name) != std::string::npos) << name;
    }
    EXPECT_GT(n, 90);
}

}  // namespace
}  // namespace graincrack::test
