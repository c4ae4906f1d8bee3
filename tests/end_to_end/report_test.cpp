// A report of tests of a calibrated rock compares them with its laboratory.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

/// The row of a table of the page that begins with a property.
std::string row_of(const std::string& page, const std::string& property) {
    const std::size_t from = page.find("<td>" + property + "</td>");
    return from == std::string::npos ? "" : page.substr(from, page.find("</tr>", from) - from);
}

TEST(Report, TestsOfACalibratedGraniteStandBesideItsTargets) {
    const Shell shell;
    shell.must(
        "for seed in 1 2; do\n"
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 4mm --material augig-granite-triangles --seed $seed "
        "--quiet -o $seed.h5\n"
        "graincrack-solve uniaxial $seed.h5 --material augig-granite-triangles --rate-tolerance 0.006 --quiet -o u$seed.h5\n"
        "graincrack-solve triaxial $seed.h5 --confining-pressure 8MPa --material augig-granite-triangles --rate-tolerance 0.006 "
        "--quiet -o t$seed.h5\ndone\n"
        "graincrack-post report u1.h5 u2.h5 t1.h5 t2.h5 --material augig-granite-triangles --quiet -o "
        "page.html");
    const std::string page = content_of(shell.file("page.html"));
    // The laboratory's values are those of [targets]; each has a verdict, and what the calibration did not use is a prediction.
    struct Expected {
        std::string property;
        std::string laboratory;
        std::string origin;
    };
    for (const Expected& expected : {Expected{"UCS", "122 ± 6.1\u00a0MPa", "fitted"},
                                     {"σ1 at σ3 = 8 MPa", "193.5 ± 15\u00a0MPa", "fitted"},
                                     {"crack initiation CI", "55 ± 12\u00a0MPa", "predicted"},
                                     {"crack damage CD", "98 ± 18\u00a0MPa", "predicted"}}) {
        const std::string row = row_of(page, expected.property);
        EXPECT_NE(row.find("<td>" + expected.laboratory + "</td>"), std::string::npos) << row;
        EXPECT_NE(row.find("(2\u00a0runs)"), std::string::npos) << row;
        EXPECT_TRUE(row.ends_with("<td>" + expected.origin + "</td>")) << row;
        const bool has_verdict = row.find("<td>within</td>") != std::string::npos ||
                                 row.find("<td>outside</td>") != std::string::npos ||
                                 row.find("<td>undecided</td>") != std::string::npos;
        EXPECT_TRUE(has_verdict) << row;
    }
    EXPECT_NE(row_of(page, "direct tensile strength").find("not tested"), std::string::npos);
    // [fitted] in the words of a laboratory.
    EXPECT_NE(page.find("<td>UCS</td><td>122 MPa</td><td>124.6\u00a0MPa</td><td>117.6 to 131.6</td><td>6</td>"),
              std::string::npos);
    EXPECT_EQ(page.find("compressive_strength"), std::string::npos);
    // The runs name their material.
    shell.must("graincrack-post report u1.h5 --quiet -o alone.html");
    EXPECT_NE(row_of(content_of(shell.file("alone.html")), "UCS").find("<td>122 ± 6.1\u00a0MPa</td>"), std::string::npos);
    // The first screen: curve, cracks, envelope.
    EXPECT_NE(page.substr(0, page.find("<h2")).find("class=\"first of3\""), std::string::npos);
}

}  // namespace
}  // namespace graincrack::test
