# The targets in reports of calibrations (report.md) as one table, a row a target. Names of targets become one word and lose their unit.
BEGIN {
    OFS = "\t"
    print "rock", "ended", "target", "asked", "laboratory", "new_specimens", "low", "high", "with_it", "off", "bound", "verdict"
}
FNR == 1 { split(substr($0, 3), title, ": "); targets = 0; next }
/^#/ { targets = $0 == "## Targets"; row = 0 }
targets && /^\|/ && ++row > 2 {
    split($0, cell, / *\| */)
    name = cell[2]
    sub(/, [^,]*$/, "", name)
    gsub(/ /, "_", name)
    split(cell[5], value, /[ ()]+(to )?/)
    print title[1], title[2], name, cell[3], cell[4], value[1], value[2], value[3], cell[6], cell[7], cell[8], cell[9]
}
