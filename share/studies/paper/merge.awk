# claims.tsv of the studies to one row a claim: at the paper's microparameters, at ours, and with minerals at the paper's. Rows of Table 9 become one.
# Set by -v: n_theirs, how many of the files come first, those at the paper's microparameters; n_ours, how many follow.
BEGIN { FS = "\t" }
FNR == 1 { head(); ++file; next }
{
    key = value("study") "\t" value("claim")
    if (value("claim") ~ /^Table 9/) {
        ++n_table
        if (value("verdict") == "holds") ++n_table_holds
        if (n_table == 1) order[++n] = "table 9"
        next
    }
    if (!(key in paper)) { order[++n] = key; paper[key] = value("paper") }
    side = file <= n_theirs ? "theirs" : file <= n_theirs + n_ours ? "ours" : "minerals"
    result[key, side] = value("ours"); difference[key, side] = value("difference"); verdict[key, side] = value("verdict")
    if (value("explanation") != "" && explanation[key] == "") explanation[key] = value("explanation")
    else if (value("explanation") != "" && value("explanation") != explanation[key]) explanation[key] = explanation[key] (side == "ours" ? "; at our point: " : "; with minerals: ") value("explanation")
}
END {
    print "study\tclaim\tpaper\tat_the_paper's_point\tdifference\tverdict\tat_our_point\tour_difference\tour_verdict\twith_minerals\ttheir_difference\ttheir_verdict\texplanation"
    for (i = 1; i <= n; ++i) {
        key = order[i]
        if (key == "table 9") {
            printf "fpz\tTable 9, Eq 31: b(m, n)\t%d numbers\t%d equal when rounded\t\t%s\t\t\t\t\t\t\t\n", n_table, n_table_holds, n_table == n_table_holds ? "holds" : "differs"
            continue
        }
        printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\t%s\n", key, paper[key], result[key, "theirs"], difference[key, "theirs"], verdict[key, "theirs"],
            result[key, "ours"], difference[key, "ours"], verdict[key, "ours"],
            result[key, "minerals"], difference[key, "minerals"], verdict[key, "minerals"], explanation[key]
    }
}
