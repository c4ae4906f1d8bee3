# strength-b.tsv to edges and strengths, for a power law.
BEGIN { FS = "\t"; print "test\tmean_edge_mm\tstrength_MPa" }
FNR == 1 { head(); next }
{ print value("test") "\t" value("mean_edge_mm") "\t" value("tensile_strength_MPa") value("peak_compressive_stress_MPa") }
