# levels.tsv, trends.tsv, series.tsv to the claims of §4.1. Set by -v: study, ucs, phi, bts, tc.
BEGIN { FS = "\t"; claims_head() }
FNR == 1 { head(); ++file; next }
file == 1 {
    runs[value("test") " " value("series")] += value("runs")
    n_without_peak[value("test") " " value("series")] += value("without_peak")
    next
}
file == 2 {
    key = value("group")
    gsub(/, /, " ", key)
    intercept[key] = value("intercept"); intercept_low[key] = value("intercept_low"); intercept_high[key] = value("intercept_high")
    slope[key] = value("slope"); slope_low[key] = value("slope_low"); slope_high[key] = value("slope_high")
    elasticity[key] = value("elasticity"); elasticity_low[key] = value("elasticity_low"); elasticity_high[key] = value("elasticity_high")
    fit_p[key] = value("lack_of_fit_p")
    next
}
{
    key = value("test") SUBSEP value("series") SUBSEP value("seed") SUBSEP value("level")
    strength[key] = value("strength_MPa")
    note_level(value("series"), value("level"))
    seeds[value("seed")] = 1
}
END {
    tensile = "brazilian tc_over_BTS"
    uniaxial = "uniaxial tc_over_BTS"
    claim("Fig 4a: σt is proportional to tc", "a line through 0", sprintf("σt = %.2f %s + %.3f tc", intercept[tensile], range(intercept_low[tensile], intercept_high[tensile]), slope[tensile] / bts),
        sprintf("%.0f %% of BTS at tc = 0", 100 * intercept[tensile] / bts), through_zero(tensile),
        "the interval of the intercept excludes 0: contacts that open also slide, and σt depends on their shear strength and fracture energy, which do not follow tc")
    claim("Fig 4a: σt against tc is a straight line", "linear", "lack of fit p = " (fit_p[tensile] == "" ? "-" : sprintf("%.2g", fit_p[tensile])), "",
        fit_p[tensile] == "" ? "open" : fit_p[tensile] > 0.05 ? "holds" : "differs", fit_p[tensile] == "" ? "needs three levels and two seeds" : "curved: see levels")
    at = (bts - intercept[tensile]) / slope[tensile] * bts
    claim("§4.1: tc for σt = BTS, by the line", "24.15 MPa", sprintf("%.2f MPa", at), percent(at, 24.15), judge(at, "", 24.15, 0.05),
        sprintf("d ln σt/d ln tc = %.2f %s at the mean: where it is below 0.5, tc cannot be found from σt", elasticity[tensile], range(elasticity_low[tensile], elasticity_high[tensile])))
    for (s in seeds) if (("brazilian", "tc_over_BTS", s, sprintf("%.4g", tc / bts)) in strength) add("at tc", strength["brazilian", "tc_over_BTS", s, sprintf("%.4g", tc / bts)])
    if (count("at tc")) claim("§4.1: σt at the calibrated tc, cc = UCS, φc = φ", "8.73 MPa", with_interval(mean("at tc"), half_interval("at tc"), "%.2f") sprintf(" MPa at tc = %.4g MPa", tc),
        percent(mean("at tc"), 8.73), judge(mean("at tc"), half_interval("at tc"), 8.73, 0.05), "the variant of the law determines it: the shear strength of open contacts, and Gf (share/doc/readings.md)")
    claim("Fig 4a: UCS against tc is not linear", "non-linear", "lack of fit p = " (fit_p[uniaxial] == "" ? "-" : sprintf("%.2g", fit_p[uniaxial])) sprintf(", d ln UCS/d ln tc = %.2f %s", elasticity[uniaxial], range(elasticity_low[uniaxial], elasticity_high[uniaxial])) without_peak(uniaxial), "",
        fit_p[uniaxial] == "" ? "open" : fit_p[uniaxial] <= 0.05 ? "holds" : "differs", "no curvature above the scatter")
    rises("UCS rises with cc", "Fig 4b", "uniaxial cc_over_UCS")
    rises("UCS rises with φc", "Fig 4c", "uniaxial phic_over_phi")
    flat("Fig 4c: UCS does not change with φc below 0.75 φ", "uniaxial", "phic_over_phi", 0, 0.7501, 0.05, "it still moves there")
    flat("Fig 4b: σt is independent of cc", "brazilian", "cc_over_UCS", 0, 9, 0.05, "cc matters where contacts slide: near the platens, and where the crack is oblique to the load")
    flat("Fig 4c: σt is independent of φc", "brazilian", "phic_over_phi", 0, 9, 0.05, "failed contacts have friction: near the platens, and where the crack is oblique to the load")
}
function note_level(series, level) { if (!((series, level) in has_level)) { has_level[series, level] = 1; levels[series, ++n_levels[series]] = level } }
function range(low, high) { return low == "" ? "" : sprintf("(%.2f to %.2f)", low, high) }
# Proportional: the intercept's interval has 0 in it, and there is a slope at all.
function through_zero(key) {
    if (intercept_low[key] == "") return "open"
    if (intercept_low[key] > 0 || intercept_high[key] < 0) return "differs"
    return slope_low[key] > 0 ? "holds" : "open"
}
function rises(what, source, key) {
    claim(source ": " what, "rises", sprintf("d ln/d ln = %.2f %s", elasticity[key], range(elasticity_low[key], elasticity_high[key])) without_peak(key), "",
        slope_low[key] == "" ? "open" : slope_low[key] > 0 ? "holds" : slope_high[key] < 0 ? "differs" : "open", "no slope above the scatter")
}
function without_peak(key) { return n_without_peak[key] ? sprintf("; %d of %d runs end at the strain limit, without a peak", n_without_peak[key], runs[key]) : "" }
# Changes of the mean over the levels of a series between two bounds, on the same specimens: ratios to the level 1 (or the
# highest) of the same seed, whose mean must stay within the tolerance at every level.
function flat(what, test, series, low, high, tolerance, explanation,    i, s, l, base, worst, half, m, h, verdict, key, at_level) {
    for (i = 1; i <= n_levels[series]; ++i) {
        l = levels[series, i]
        if (l >= low && l <= high && (base == "" || nearer(l, base, high))) base = l
    }
    verdict = ""
    for (i = 1; i <= n_levels[series]; ++i) {
        l = levels[series, i]
        if (l < low || l > high || l == base) continue
        key = what " " l
        for (s in seeds) if (((test, series, s, l) in strength) && ((test, series, s, base) in strength))
            add(key, strength[test, series, s, l] / strength[test, series, s, base] - 1)
        if (!count(key)) continue
        m = mean(key)
        h = half_interval(key)
        if (worst == "" || abs(m) > abs(worst)) { worst = m; half = h }
        at_level = judge(1 + m, h, 1, tolerance)
        if (verdict == "" || at_level == "differs" || (at_level == "open" && verdict == "holds")) verdict = at_level
    }
    if (verdict == "") return
    claim(what, "equal", "at most " with_interval(100 * worst, half == "" ? "" : 100 * half, "%.1f") " %", sprintf("%+.1f %%", 100 * worst), verdict,
        verdict == "open" ? "the interval is too wide for a verdict: more seeds are needed" : explanation)
}
# Level 1 is the base where it is in the range, else the highest.
function nearer(a, b, high) { return high >= 1 ? abs(a - 1) < abs(b - 1) : a > b }
