# A Markdown page on stdout from its components, in the order of the arguments: texts (.md) as they are, tables (.tsv) as Markdown
# tables under their names, pictures by links. Numbers are rounded to four digits; units are in the headers.
BEGIN {
    FS = "\t"
    for (i = 1; i < ARGC; ++i) {
        file = ARGV[i]
        name = file
        sub(/.*\//, "", name)
        if (file ~ /\.md$/) { while ((getline line < file) > 0) print line; print "" }
        else if (file ~ /\.tsv$/) print_table(file, name)
        else if (file ~ /\.(png|svg)$/) printf "![%s](%s)\n\n", title(name), name
        close(file)
    }
}
function title(name) { sub(/\.[a-z]+$/, "", name); gsub(/[-_]/, " ", name); return toupper(substr(name, 1, 1)) substr(name, 2) }
function print_table(file, name,    row, rule, j) {
    printf "## %s\n\n", title(name)
    while ((getline line < file) > 0) {
        n = split(line, entries, "\t")
        row = "|"
        for (j = 1; j <= n; ++j) row = row " " entry(entries[j], row_number) " |"
        print row
        if (row_number++ == 0) { rule = "|"; for (j = 1; j <= n; ++j) rule = rule "---|"; print rule }
    }
    row_number = 0
    print ""
}
function entry(text, row) {
    if (row == 0) gsub(/_/, " ", text)
    if (row > 0 && text ~ /^-?[0-9]+\.[0-9]+(e[-+]?[0-9]+)?$/ && length(text) > 6) return sprintf("%.4g", text)
    gsub(/\|/, "\\|", text)
    return text
}
