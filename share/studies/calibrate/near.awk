# Rows of levels for a fit: all, or (refit) those within a factor 2 of the level `near`; each disc's strengths divided by what the disc
# itself differs from the mean of all discs by, since all were tested at the same levels. (The interval of a fit to these is narrower by
# the freedom of as many means as there are discs.)
BEGIN { FS = "\t" }
FNR == 1 { head(); print; next }
!refit || (value("level") >= near / 2 && value("level") <= near * 2) {
    level[++n] = value("level")
    seed[n] = value("seed")
    strength[n] = log(value("tensile_strength_MPa"))
    of_seed[seed[n]] += strength[n]
    ++tests_of_seed[seed[n]]
    all += strength[n]
}
END { for (i = 1; i <= n; ++i) printf "%s\t%s\t%.6g\n", level[i], seed[i], exp(strength[i] - of_seed[seed[i]] / tests_of_seed[seed[i]] + all / n) }
