# The columns of tables by their names. In a rule: `head()` on the first line of a file; then value("verdict") is the entry of this line.
function head(    i) {
    delete column
    for (i = 1; i <= NF; ++i) column[$i] = i
}
function value(name) {
    if (!(name in column)) { print FILENAME ": no column " name > "/dev/stderr"; failed = 1; exit 1 }
    return $column[name]
}
function has(name) { return name in column }
