# Claims of the paper beside our results: a line of claims.tsv for each.
function claims_head() { print "study\tclaim\tpaper\tours\tdifference\tverdict\texplanation" }
function claim(what, paper, ours, difference, verdict, explanation) {
    printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\n", study, what, paper, ours, difference, verdict, verdict == "holds" ? "" : explanation
}
function percent(ours, paper) { return sprintf("%+.1f %%", 100 * (ours / paper - 1)) }
# Verdict on a mean with half its interval against the paper's number. Within the tolerance (relative) it holds if the interval is no
# wider than the tolerance, otherwise it is open. Outside of the tolerance it differs, or is open if the interval reaches into the
# tolerance. Without an interval ("") the number alone counts.
function judge(ours, half, paper, tolerance,    off) {
    off = ours - paper
    if (off < 0) off = -off
    if (off <= tolerance * paper) return half == "" || half <= tolerance * paper ? "holds" : "open"
    return half != "" && off - half <= tolerance * paper ? "open" : "differs"
}
function with_interval(x, half, form) { return half == "" ? sprintf(form, x) : sprintf(form " ± " form, x, half) }
