# The first POINTS points of the box of factors that a table has, each a step of the golden ratio of its dimensions on from the last, so that any number of
# them fills the box as well as it can: the factors, and x1, x2, …, which are -1 and 1 at the sides of the box.
#
#     awk -f points.awk -v POINTS=40 box.tsv >points.tsv
BEGIN { FS = OFS = "\t" }
FNR > 1 { factor[++dimensions] = $1; low[dimensions] = $2; high[dimensions] = $3; is_logarithmic[dimensions] = $4 }
END {
    ratio = 1.5
    for (i = 0; i < 100; ++i) ratio = (1 + ratio) ^ (1 / (dimensions + 1))
    printf "point"
    for (j = 1; j <= dimensions; ++j) printf "\t%s", factor[j]
    for (j = 1; j <= dimensions; ++j) printf "\tx%d", j
    for (point = 1; point <= POINTS; ++point) {
        printf "\np%d", point
        for (j = 1; j <= dimensions; ++j) {
            share = 0.5 + point / ratio ^ j
            share -= int(share)
            coded[j] = 2 * share - 1
            printf "\t%.4g", is_logarithmic[j] ? low[j] * (high[j] / low[j]) ^ share : low[j] + share * (high[j] - low[j])
        }
        for (j = 1; j <= dimensions; ++j) printf "\t%.6g", coded[j]
    }
    print ""
}
