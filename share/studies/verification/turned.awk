# strength.tsv of discs loaded along four of their diameters to a row a disc: σt at each angle, and the standard deviation over the
# angles; the last row has the means, and the standard deviation over the discs at one angle, averaged over the angles.
BEGIN { FS = "\t"; print "disc\tat_0_deg_MPa\tat_30_deg_MPa\tat_60_deg_MPa\tat_90_deg_MPa\tdeviation_over_angles_percent\tdeviation_over_discs_percent" }
FNR == 1 { head(); next }
{
    seed = seed_of(value("file"))
    direction = specimen_of(value("file"))
    sub(/-s.*/, "", direction)
    sub(/.*d/, "", direction)
    if (!count("disc " seed)) order[++n] = seed
    strength[seed, direction] = value("tensile_strength_MPa")
    add("disc " seed, value("tensile_strength_MPa"))
    add("angle " direction, value("tensile_strength_MPa"))
}
END {
    for (i = 1; i <= n; ++i) {
        seed = order[i]
        spread = 100 * deviation("disc " seed) / mean("disc " seed)
        add("spread", spread)
        printf "%s\t%.4g\t%.4g\t%.4g\t%.4g\t%.3g\t\n", seed, strength[seed, 0], strength[seed, 1], strength[seed, 2], strength[seed, 3], spread
    }
    for (d = 0; d < 4; ++d) if (count("angle " d) > 1) add("between", 100 * deviation("angle " d) / mean("angle " d))
    printf "mean\t%.4g\t%.4g\t%.4g\t%.4g\t%.3g\t%s\n", mean("angle 0"), mean("angle 1"), mean("angle 2"), mean("angle 3"), mean("spread"),
        count("between") ? sprintf("%.3g", mean("between")) : ""
}
