# Means with 95 % intervals by Student's t, lines. Samples have names: add("tc 18", 9.5).
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
function abs(x) { return x < 0 ? -x : x }
