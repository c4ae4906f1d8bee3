# Claims of the paper beside ours: a line each of claims.tsv.
function claims_head() { print "study\tclaim\tpaper\tours\tdifference\tverdict\texplanation" }
function claim(what, paper, ours, difference, verdict, explanation) {
    printf "%s\t%s\t%s\t%s\t%s\t%s\t%s\n", study, what, paper, ours, difference, verdict, verdict == "holds" ? "" : explanation
}
function percent(ours, paper) { return sprintf("%+.1f %%", 100 * (ours / paper - 1)) }
# A mean with half its interval against a number: within the tolerance (a share) it holds if the interval is no wider than the
# tolerance either; outside it differs, unless the interval reaches into the tolerance. Else it is open. Without an interval ("")
# the number alone counts.
function judge(ours, half, paper, tolerance,    off) {
    off = ours - paper
    if (off < 0) off = -off
    if (off <= tolerance * paper) return half == "" || half <= tolerance * paper ? "holds" : "open"
    return half != "" && off - half <= tolerance * paper ? "open" : "differs"
}
function with_interval(x, half, form) { return half == "" ? sprintf(form, x) : sprintf(form " ± " form, x, half) }
