# The first part of a calibration's report, as a section of the page: its result and targets, or why it stopped. Set by -v: report, its address.
/^## Values/ { exit }
NR == 1 { sub(/^# /, "## ") }
{ print }
END { print "[The whole report](" report "), with every step." }
