# wanted.tsv to names of runs, without what make's variables add: uniaxial_rectangle80x160g1122-s1_tc18_cc122_phic53_cap0.015. Set by
# -v: material, the runs of which are wanted.
BEGIN {
    FS = "\t"
    n = split("tc contact_tensile_strength_MPa cc contact_cohesion_MPa phic contact_friction_angle_deg gf contact_fracture_energy_J/m2 os contact_open_shear_strength_MPa cap max_strain", token, " ")
}
NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
$column["material"] == material {
    name = $column["test"] ($column["test"] == "triaxial" ? $column["confining_pressure_MPa"] : "") "_" $column["specimen"] "-s" $column["seed"]
    for (i = 1; i < n; i += 2) if ($column[token[i + 1]] != "") name = name "_" token[i] $column[token[i + 1]]
    print name
}
