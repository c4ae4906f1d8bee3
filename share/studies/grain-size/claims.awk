# exponents.tsv and sizes.tsv to the claims of §6.2 and Eq 44. Set by -v: study, energies (of series c).
BEGIN { FS = "\t"; claims_head() }
FNR == 1 { head(); ++file; next }
file == 1 {
    key = value("series") " " value("test") (value("test") == "triaxial" ? value("confining_pressure_MPa") + 0 : "")
    exponent[key] = value("exponent"); low[key] = value("exponent_low"); high[key] = value("exponent_high")
    zone[key] = value("zone_over_smallest_edge") == "" ? "" : sprintf("; contact zone %.2g to %.2g edges", value("zone_over_smallest_edge"), value("zone_over_largest_edge"))
    next
}
{
    key = value("series") " " value("test")
    add(key, value("strength_MPa"))
    add("half " key, value("low_MPa") == "" ? 0 : (value("high_MPa") - value("low_MPa")) / 2)
    n_without_peak[key] += value("without_peak")
}
END {
    flat("uniaxial", "UCS")
    flat("triaxial8", "σ1 at 8 MPa")
    tensile = "a brazilian"
    claim("Fig 10: σt rises with grain size", "rises", of(tensile), "", low[tensile] == "" ? "open" : low[tensile] > 0 ? "holds" : high[tensile] < 0 ? "differs" : "open", "no exponent above the scatter")
    claim("Fig 10: exponent of σt", "0.39", of(tensile), sprintf("%+.2f", exponent[tensile] - 0.39), inside(tensile, 0.39), "theory with a fixed Gf expects 0 where the contact zone is much longer than a grain, 0.5 where it is much shorter; σt of this law is determined by the shear strength of open contacts (share/doc/readings.md), a stress without a length scale" zone[tensile])
    claim("Eq 44: exponent of σt, theory", "0.5", of(tensile), sprintf("%+.2f", exponent[tensile] - 0.5), inside(tensile, 0.5), "as above: tc √dp holds for a sharp crack between grains that break at once")
    claim("Eq 40: with tc = 2 K_IC/√(π dp) at each size, σt does not depend on it", "exponent 0", of("b brazilian"), "", inside("b brazilian", 0), "σt does not depend on tc alone")
    n = split(energies, energy, " ")
    for (i = 1; i <= n; ++i) {
        key = "c" energy[i] " brazilian"
        if (!(key in exponent)) continue
        claim("Fig 10: exponent of σt with Gf " energy[i] (energy[i] ~ /^[0-9]/ ? " J/m2" : ""), "0.39", of(key), sprintf("%+.2f", exponent[key] - 0.39), inside(key, 0.39), "as above" zone[key])
    }
}
function of(key) { return (key in exponent) ? sprintf("%.2f", exponent[key]) (low[key] == "" ? "" : sprintf(" (%.2f to %.2f)", low[key], high[key])) : "not run" }
function inside(key, x) { return low[key] == "" ? "open" : low[key] > x || high[key] < x ? "differs" : high[key] - low[key] > 0.5 ? "open" : "holds" }
# The largest over the smallest mean of the sizes, against 10 %.
function flat(test, symbol,    key, i, least, most, spread, noise) {
    key = "a " test
    if (count(key) < 2) return
    for (i = 1; i <= count(key); ++i) {
        if (least == "" || sample[key, i] < least) { least = sample[key, i]; noise_least = sample["half " key, i] }
        if (most == "" || sample[key, i] > most) { most = sample[key, i]; noise_most = sample["half " key, i] }
    }
    spread = most / least - 1
    noise = sqrt(noise_least ^ 2 + noise_most ^ 2) / least
    claim("Fig 10: " symbol " does not depend on grain size", "nearly equal: < 10 %", sprintf("%.1f %% between sizes, exponent %s", 100 * spread, of(key)), sprintf("%+.1f %%", 100 * spread),
        spread < 0.1 ? "holds" : spread - noise < 0.1 ? "open" : "differs", (n_without_peak[key] ? "runs without a peak: " n_without_peak[key] "; " : "") "the means of the extreme sizes differ by more than 10 %")
}
