# Means with 95 % intervals by Student's t, lines, ranks. Samples have names: add("tc 18", 9.5).
function add(name, x) {
    ++n_of[name]
    sample[name, n_of[name]] = x + 0
}
function count(name) { return (name in n_of) ? n_of[name] : 0 }
function mean(name,    i, sum) {
    for (i = 1; i <= n_of[name]; ++i) sum += sample[name, i]
    return sum / n_of[name]
}
# Standard deviation (n − 1); "" for fewer than two.
function deviation(name,    i, m, sum) {
    if (count(name) < 2) return ""
    m = mean(name)
    for (i = 1; i <= n_of[name]; ++i) sum += (sample[name, i] - m) ^ 2
    return sqrt(sum / (n_of[name] - 1))
}
# Half of the 95 % interval of the mean; "" for fewer than two.
function half_interval(name) { return count(name) < 2 ? "" : student(n_of[name] - 1) * deviation(name) / sqrt(n_of[name]) }
# t of 97.5 %: the table to 10 degrees of freedom, then Abramowitz & Stegun 26.7.5, good to 0.002 there.
function student(freedom,    table, z) {
    if (freedom <= 10) {
        split("12.7062 4.3027 3.1824 2.7764 2.5706 2.4469 2.3646 2.3060 2.2622 2.2281", table, " ")
        return table[freedom]
    }
    z = 1.959964
    return z + (z ^ 3 + z) / (4 * freedom) + (5 * z ^ 5 + 16 * z ^ 3 + 3 * z) / (96 * freedom ^ 2)
}
# Least squares y = a + b x through two samples: sets line_a, line_b. Needs two different x.
function line(xs, ys,    i, n, x, y, sxx, sxy) {
    n = n_of[xs]
    x = mean(xs)
    y = mean(ys)
    for (i = 1; i <= n; ++i) {
        sxx += (sample[xs, i] - x) ^ 2
        sxy += (sample[xs, i] - x) * (sample[ys, i] - y)
    }
    line_b = sxy / sxx
    line_a = y - line_b * x
}
# Spearman's rank correlation of two samples, ties by mean ranks.
function spearman(xs, ys,    i, n) {
    n = n_of[xs]
    for (i = 1; i <= n; ++i) {
        add("ranks " xs " " ys " x", rank(xs, i))
        add("ranks " xs " " ys " y", rank(ys, i))
    }
    return correlation("ranks " xs " " ys " x", "ranks " xs " " ys " y")
}
function rank(name, i,    j, below, equal) {
    for (j = 1; j <= n_of[name]; ++j) {
        if (sample[name, j] < sample[name, i]) ++below
        if (sample[name, j] == sample[name, i]) ++equal
    }
    return below + (equal + 1) / 2
}
function correlation(xs, ys,    i, x, y, sxx, syy, sxy) {
    x = mean(xs)
    y = mean(ys)
    for (i = 1; i <= n_of[xs]; ++i) {
        sxx += (sample[xs, i] - x) ^ 2
        syy += (sample[ys, i] - y) ^ 2
        sxy += (sample[xs, i] - x) * (sample[ys, i] - y)
    }
    return sxx * syy > 0 ? sxy / sqrt(sxx * syy) : ""
}
function median(name,    i, j, x, sorted) {
    for (i = 1; i <= n_of[name]; ++i) {
        x = sample[name, i]
        for (j = i - 1; j >= 1 && sorted[j] > x; --j) sorted[j + 1] = sorted[j]
        sorted[j + 1] = x
    }
    return n_of[name] % 2 ? sorted[(n_of[name] + 1) / 2] : (sorted[n_of[name] / 2] + sorted[n_of[name] / 2 + 1]) / 2
}
function abs(x) { return x < 0 ? -x : x }
