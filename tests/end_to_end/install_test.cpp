// An installation works without the source tree, also after it was moved.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Install, ToolsFindTheMaterialsTheyCameWith) {
    const Shell shell;
    shell.must("cmake --install " GRAINCRACK_BIN
               "/.. --prefix installed >/dev/null\nmv installed moved\n"
               "materials=moved/share/graincrack/materials\n"
               "sed 's/^name = .*/name = \"Of this place alone\"/' $materials/augig-granite.toml >$materials/of-this-place.toml");
    const std::string tools = "PATH=$PWD/moved/bin:$PATH\n";
    shell.must(
        tools + make_disc + "disc.h5 --material of-this-place\n" +
        "graincrack-solve brazilian disc.h5 --material of-this-place --max-strain 0.0003 --rate 400mm/s --quiet -o run.h5");
    EXPECT_NE(shell.must(tools + "graincrack-post info run.h5").find("Of this place alone"), std::string::npos);
    EXPECT_NE(content_of(shell.file("moved/share/graincrack/doc/file-format.md")), "");
    for (const char* file : {"doc/graincrack/README.md", "doc/graincrack/copyright", "doc/graincrack/CITATION.cff",
                             "bash-completion/completions/graincrack-solve", "zsh/vendor-completions/_graincrack-post"}) {
        EXPECT_NE(content_of(shell.file(std::string("moved/share/") + file)), "") << file;
    }
    EXPECT_EQ(
        shell.must("cd moved/share/doc/graincrack; for page in README.md share/doc/*.md; do grep -oE '\\]\\([^)#:]+' $page | "
                   "cut -c3- | while read -r link; do test -e $(dirname $page)/$link || echo $page $link; done; done; true"),
        "");
    EXPECT_EQ(shell.run("grep -rlF " GRAINCRACK_BIN " moved").out, "");               // nothing of the build is in it
    EXPECT_EQ(shell.run("grep -rlF " GRAINCRACK_SOURCE "/share moved/bin").out, "");  // nor of the sources
    EXPECT_NE(content_of(shell.file("moved/share/man/man1/graincrack-post-plot-cracks.1.gz")), "");
    EXPECT_EQ(shell.must("PYTHONPATH=moved/lib/python3/dist-packages /usr/bin/python3 -c \"import graincrack; "
                         "print(graincrack.Run('run.h5').test)\""),
              "brazilian\n");
    // The studies as from the tree; what they leave is where they are called.
    shell.must("ln -s moved/share/graincrack share\nunset CALLED_FROM OUT MAKEFLAGS MAKELEVEL\nmake -s -C share/studies fpz");
    EXPECT_NE(content_of(shell.file("results/fpz/page.md")), "");
}

TEST(Install, BelowUsrLocalItIsWhereZshAndPythonLook) {
    const Shell shell;
    shell.must("cmake --install " GRAINCRACK_BIN "/.. --prefix $PWD/usr/local >/dev/null");
    EXPECT_NE(content_of(shell.file("usr/local/share/zsh/site-functions/_graincrack-solve")), "");
    // The folders below /usr/local that Python itself names, below this prefix.
    EXPECT_EQ(
        shell.must("/usr/bin/python3 -c \"import sys, os; print(sum(os.path.exists('.' + p + '/graincrack/__init__.py') for p in "
                   "sys.path if p))\""),
        "1\n");
}

// "not-installed" is what dpkg says of a package that another one mentions.
TEST(Install, APackageThatDpkgOnlyKnowsOfIsMissing) {
    const Shell shell;
    write_text(shell.file("dpkg-query"),
               "#!/bin/sh\ncase $3 in here) printf 'installed ';; known) printf 'not-installed ';; *) exit 1;; esac\n");
    write_text(shell.file("apt-get"), "#!/bin/sh\nexit 1\n");
    const Outcome outcome = shell.run("chmod +x dpkg-query apt-get; PATH=$PWD:$PATH; source " GRAINCRACK_SOURCE
                                      "/share/setup.sh; have_packages here known unknown");
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find(" known unknown"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("here known"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace graincrack::test
