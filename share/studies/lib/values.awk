# The parameters in reports of calibrations (report.md) as one table, a row a parameter.
BEGIN {
    OFS = "\t"
    print "rock", "ended", "parameter", "value", "interval", "first_guess"
}
FNR == 1 { split(substr($0, 3), title, ": "); values = 0; next }
/^#/ { values = $0 == "## Values"; row = 0 }
values && /^\|/ && ++row > 2 {
    split($0, cell, / *\| */)
    print title[1], title[2], cell[2], cell[3], cell[4], cell[5]
}
