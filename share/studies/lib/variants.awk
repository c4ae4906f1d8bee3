# Tables of one form to one table with the variant of each run, the first token of its name: scaled of scaled and of scaled-at12.
BEGIN { FS = OFS = "\t" }
FNR == 1 { head(); if (NR == 1) print $0, "variant"; next }
{ name = variant(value("file")); sub(/-at[0-9.]+$/, "", name); print $0, name }
