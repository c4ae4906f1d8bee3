# The rows of one series of series.tsv, its level under its own name: for the pictures. Set by -v: series.
BEGIN { FS = OFS = "\t" }
NR == 1 { head(); print "test", series, "strength_over_laboratory"; next }
value("series") == series { print value("test"), value("level"), value("normalised") }
