# The Lennard-Jones potential P(z)/X = a [(ζ/z)^n − (ζ/z)^m] with a = (1/(n − m)) (n^n/m^m)^(1/(n − m)) (Eqs 20–22); its depth is 1.
BEGIN {
    print "z_over_zeta\tP_over_X_8_13\tP_over_X_12_18"
    for (z = 0.98; z < 2.005; z += 0.01) printf "%.2f\t%.6f\t%.6f\n", z, potential(z, 8, 13), potential(z, 12, 18)
}
function potential(z, m, n) { return exp((n * log(n) - m * log(m)) / (n - m)) / (n - m) * (z ^ -n - z ^ -m) }
