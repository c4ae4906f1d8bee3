# exponents-SERIES.tsv to one table: the power law through logarithms of each series, test and confining pressure.
BEGIN { FS = "\t"; print "series\ttest\tconfining_pressure_MPa\truns\truns_at_strain_limit\texponent\texponent_low\texponent_high\tcoefficient_MPa\tzone_over_smallest_edge\tzone_over_largest_edge" }
FNR == 1 { head(); series = FILENAME; sub(/.*exponents-/, "", series); sub(/\.tsv$/, "", series); next }
# rows of `trend --power` have no contact zone, which depends on the size
has("elasticity") {
    print series "\t" value("group") "\t\t" value("n") "\t\t" value("elasticity") "\t" value("elasticity_low") "\t" value("elasticity_high") "\t" value("coefficient") "\t\t"
    next
}
value("fit") == "log-log" {
    print series "\t" value("test") "\t" value("confining_pressure_MPa") "\t" value("runs") "\t" value("runs_at_strain_limit") "\t" value("exponent") "\t" value("exponent_low") "\t" \
        value("exponent_high") "\t" value("coefficient") "\t" value("zone_over_smallest_edge") "\t" value("zone_over_largest_edge")
}
