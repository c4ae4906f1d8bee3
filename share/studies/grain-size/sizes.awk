# strength-SERIES.tsv to one table with the series, and the size as in the name of the run.
BEGIN { FS = OFS = "\t" }
FNR == 1 { head(); series = FILENAME; sub(/.*strength-/, "", series); sub(/\.tsv$/, "", series); if (NR == 1) print $0, "series", "size"; next }
{ test = column["test"]; $test = test_of(value("file")); print $0, series, size_of(value("file")) }
