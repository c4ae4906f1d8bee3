# The design of the study: 68 points, each a step of the golden ratio of nine dimensions on from the last, so that the first n points fill the box as well as n points can. Stresses are over the tensile strength tc of contacts, lengths
# over the grain size d, energies E G/(tc² d). Friction
# angles of the last eight are small.
#
#     awk -f design.awk >design.tsv
function between(low, high) { return low + (high - low) * u[++used] }
function log_between(low, high) { return low * (high / low) ^ u[++used] }
BEGIN {
    OFS = "\t"
    dimensions = 9
    ratio = 1.5
    for (i = 0; i < 100; ++i) ratio = (1 + ratio) ^ (1 / (dimensions + 1))
    print "point", "cohesion", "friction_angle_deg", "residual_friction_angle_deg", "process_zone", "mode_ii_fracture_energy", "bridging_strength",
        "bridging_energy", "low_pressure", "high_pressure"
    for (point = 1; point <= 68; ++point) {
        for (j = 1; j <= dimensions; ++j) {
            u[j] = 0.5 + point / ratio ^ j
            u[j] -= int(u[j])
        }
        used = 0
        cohesion = log_between(1.5, 16)
        friction = point > 60 ? between(22, 34) : between(32, 58)
        residual = between(5, 30)
        zone = log_between(0.5, 3)
        shear = log_between(15, 150)
        bridge = between(-0.27, 0.8)  # a quarter of the points has none
        energy = log_between(3, 20)
        low = log_between(0.25, 2)
        high = log_between(1.5, 9)
        print point, sprintf("%.4g", cohesion), sprintf("%.4g", friction), sprintf("%.4g", (residual < friction ? residual : friction)),
            sprintf("%.4g", zone), sprintf("%.4g", shear), (bridge > 0 ? sprintf("%.3g", bridge) : 0), (bridge > 0 ? sprintf("%.4g", energy) : 0),
            sprintf("%.3g", low), sprintf("%.3g", high)
    }
}
