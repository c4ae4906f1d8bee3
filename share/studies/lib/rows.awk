# A table as Markdown by a template. Set by -v: header, "| variant | UCS, MPa |"; row, "| {variant} | [{mean %.1f} ± {half %.1f};{mean %.1f}] |".
# {COLUMN FORMAT} is an entry. Of the alternatives in [] the first without an empty entry is taken, - if there is none.
BEGIN { FS = "\t" }
FNR == 1 { head(); rule = header; gsub(/[^|]+/, "---", rule); print header; print rule; next }
{
    line = row
    while (match(line, /\[[^]]*\]/)) {
        after = substr(line, RSTART + RLENGTH)
        line = substr(line, 1, RSTART - 1) chosen(substr(line, RSTART + 1, RLENGTH - 2)) after
    }
    print filled(line)
}
function chosen(text,    n, parts, i) {
    n = split(text, parts, ";")
    for (i = 1; i <= n; ++i) if (filled(parts[i]) != "") return filled(parts[i])
    return "-"
}
function filled(text,    words, entry) {
    while (match(text, /\{[^}]*\}/)) {
        split(substr(text, RSTART + 1, RLENGTH - 2), words, " ")
        if ((entry = value(words[1])) == "") return ""
        text = substr(text, 1, RSTART - 1) (words[2] == "" ? entry : sprintf(words[2], entry)) substr(text, RSTART + RLENGTH)
    }
    return text
}
