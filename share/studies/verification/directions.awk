# summary.tsv, rosette.tsv and cracks.tsv of each run to one row for each run: the share of the length of the tensile cracks at the peak that
# lies within 30° of the load (y), and the same share for all facets of the specimen.
BEGIN { FS = "\t"; print "run\ttensile_length_m\ttensile_share_within_30_deg\tfacet_share_within_30_deg" }
FNR == 1 {
    head()
    if (has("share_with_more_sliding")) { finish(); run = ""; along = total = facets_along = facets = 0 }
    next
}
has("share_with_more_sliding") { if (value("at") == "peak") { run = stem(value("file")); peak = value("time_s") } next }
has("facet_length_m") {
    facets += value("facet_length_m")
    if (value("orientation_low_deg") >= 60 && value("orientation_high_deg") <= 120) facets_along += value("facet_length_m")
    next
}
value("mode") == "tensile" && value("time_s") <= peak {
    total += value("length_m")
    turned = value("orientation_rad") / atan2(0, -1) * 180 % 180
    if (turned < 0) turned += 180
    if (turned >= 60 && turned <= 120) along += value("length_m")
}
END { finish() }
function finish() { if (run != "") printf "%s\t%.5g\t%s\t%.4f\n", run, total, (total > 0 ? sprintf("%.4f", along / total) : ""), facets_along / facets }
