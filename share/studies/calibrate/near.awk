# Rows of levels for a fit: all, or (refit) those within a factor 2 of the level `near` if these are at least three levels. All discs were
# tested at the same levels; the strengths of each disc are divided by the ratio of its mean to the mean of all discs. (The fit does not
# count these means as fitted, so that its interval is slightly too narrow.)
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
