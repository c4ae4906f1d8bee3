# moduli.tsv of assemblages whose grains have e (MPa) and nu: prints their measured E (MPa) and ν, and the E and ν of the grains for which
# the assemblages would have target_e and target_nu: by the compliance formula 1/E' = 1/E + Sv (3/(8 kt) + 1/(8 ks)), ν' = [ν/E − (Sv/8)(1/kt − 1/ks)] E'
# in plane values, with Sv, the contact length per area, from the column predicted_…, times the ratio of measured to predicted values.
# Set by -v: e, nu, k1, k2 (MPa√m), st (BTS, MPa), target_e, target_nu.
BEGIN { FS = "\t" }
FNR == 1 { head(); next }
{
    ++n
    measured_e += value("young_modulus_GPa") * 1000
    measured_nu += value("poisson_ratio")
    predicted_e += value("predicted_young_modulus_GPa") * 1000
    predicted_nu += value("predicted_poisson_ratio")
}
END {
    if (failed) exit 1
    measured_e /= n; measured_nu /= n; predicted_e /= n; predicted_nu /= n
    plane = predicted_e / (1 - predicted_nu ^ 2)
    stiffnesses(e, nu)
    area = (1 / plane - (1 - nu ^ 2) / e) / (3 / (8 * kt) + 1 / (8 * ks))
    x = e
    y = nu
    for (i = 0; i < 200; ++i) {
        assemblage(x, y)
        x *= target_e / (e_of * measured_e / predicted_e)
        y += 0.5 * (target_nu - (nu_of + measured_nu - predicted_nu))
        if (y < 0) y = 0
        if (y > 0.49) y = 0.49
    }
    printf "%.5g %.4g %.5g %.4g\n", measured_e, measured_nu, x, y
}
# Eqs 3–5, plane strain, MPa/m.
function stiffnesses(e, nu) {
    kt = e ^ 2 * st / (4 * (1 - nu ^ 2) * k1 ^ 2)
    ks = e / (2 * (1 + nu)) * e * st / (4 * (1 - nu ^ 2) * k2 ^ 2)
}
function assemblage(e, nu,    ep, np, eq, nq) {
    stiffnesses(e, nu)
    ep = e / (1 - nu ^ 2)
    np = nu / (1 - nu)
    eq = 1 / (1 / ep + area * (3 / (8 * kt) + 1 / (8 * ks)))
    nq = (np / ep - area / 8 * (1 / kt - 1 / ks)) * eq
    nu_of = nq / (1 + nq)
    e_of = eq * (1 - nu_of ^ 2)
}
