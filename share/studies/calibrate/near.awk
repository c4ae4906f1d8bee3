# Rows of levels for a fit: all, or (refit) those within a factor 2 of the level `near` if these are three levels at least. Each disc's
# strengths are divided by what the disc itself differs from the mean of all discs by, since all were tested at the same levels. (The
# interval of a fit to these is narrower by the freedom of as many means as there are discs.)
BEGIN { FS = "\t" }
FNR == 1 { head(); print; next }
{
    level[++n] = value("level")
    seed[n] = value("seed")
    strength[n] = log(value("tensile_strength_MPa"))
    if (!(level[n] in seen)) { seen[level[n]] = 1; n_near += is_near(level[n]) }
}
END {
    if (n_near < 3) refit = 0
    for (i = 1; i <= n; ++i) if (!refit || is_near(level[i])) {
        of_seed[seed[i]] += strength[i]
        ++tests_of_seed[seed[i]]
        all += strength[i]
        ++n_all
    }
    for (i = 1; i <= n; ++i) if (!refit || is_near(level[i]))
        printf "%s\t%s\t%.6g\n", level[i], seed[i], exp(strength[i] - of_seed[seed[i]] / tests_of_seed[seed[i]] + all / n_all)
}
function is_near(x) { return x >= near / 2 && x <= near * 2 }
