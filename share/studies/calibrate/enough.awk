# properties.tsv to the numbers of discs and rectangles that bring the 95 % interval of each mean below ±3 %.
# Set by -v: discs, rectangles, the numbers there are; max_discs, max_rectangles.
BEGIN { FS = "\t"; want_discs = discs; want_rectangles = rectangles }
FNR == 1 { head(); next }
value("half_interval_percent") > 3 && value("specimens_for_3_percent") != "" {
    if (value("property") == "tensile_strength_MPa") want_discs = most(want_discs, value("specimens_for_3_percent"))
    else want_rectangles = most(want_rectangles, value("specimens_for_3_percent"))
}
END { print least(want_discs, most(discs, max_discs)), least(want_rectangles, most(rectangles, max_rectangles)) }
function most(a, b) { return a + 0 > b + 0 ? a + 0 : b + 0 }
function least(a, b) { return a + 0 < b + 0 ? a + 0 : b + 0 }
