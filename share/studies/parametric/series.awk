# strength.tsv to one row for each run and each series to which it belongs: series, level (in the unit of the series), seed, test, strength.
# Set by -v: ucs, phi, bts, tc.
BEGIN { FS = "\t"; print "series\tlevel\tseed\ttest\tstrength_MPa\tnormalised\tpeak_kind\ttensile_cracks\tshear_cracks\tfile" }
FNR == 1 { head(); next }
{
    file = value("file")
    t = token(file, "tc")
    c = token(file, "cc")
    p = token(file, "phic")
    if (near(c, ucs) && near(p, phi)) row("tc_over_BTS", t / bts)
    if (near(t, tc) && near(p, phi)) row("cc_over_UCS", c / ucs)
    if (near(t, tc) && near(c, ucs)) row("phic_over_phi", p / phi)
}
function near(a, b) { return a - b < 1e-4 * b && b - a < 1e-4 * b }
function row(series, level,    strength, tensile) {
    tensile = value("tensile_strength_MPa") != ""
    strength = value("tensile_strength_MPa") value("peak_compressive_stress_MPa")
    printf "%s\t%.4g\t%s\t%s\t%s\t%.5g\t%s\t%s\t%s\t%s\n", series, level, seed_of(file), value("test"), strength,
        strength / (tensile ? bts : ucs), value("peak_kind"), value("tensile_cracks"), value("shear_cracks"), file
}
