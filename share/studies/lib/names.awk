# Settings from the name of a run, and the columns of tables.
# In a rule: `head()` on the first line of a file; then value("peak_kind") is the entry of this line.
function head(    i) {
    delete column
    for (i = 1; i <= NF; ++i) column[$i] = i
}
function value(name) {
    if (!(name in column)) { print FILENAME ": no column " name > "/dev/stderr"; failed = 1; exit 1 }
    return $column[name]
}
function has(name) { return name in column }
# "uniaxial_rectangle80x160g1122-s2_tc18" of a file
function stem(file) { sub(/.*\//, "", file); sub(/\.h5$/, "", file); return file }
function test_of(file) { file = stem(file); sub(/_.*/, "", file); return file }
function specimen_of(file,    parts) { split(stem(file), parts, "_"); return parts[2] }
function seed_of(file) { file = specimen_of(file); sub(/.*-s/, "", file); return file }
# "g1122" or "e4"
function size_of(file) {
    file = specimen_of(file)
    sub(/-s[0-9]+$/, "", file)
    match(file, /[ge][0-9.]+$/)
    return substr(file, RSTART)
}
# The number of a token, as 18 of tc18; "" if there is none.
function token(file, name,    n, parts, i) {
    n = split(stem(file), parts, "_")
    for (i = 3; i <= n; ++i) if (index(parts[i], name) == 1 && substr(parts[i], length(name) + 1) ~ /^[0-9.]/) return substr(parts[i], length(name) + 1)
    return ""
}
# Whether the name has exactly this token.
function has_token(file, name) { return index("_" stem(file) "_", "_" name "_") > 0 }
# The first token after test and specimen.
function variant(file,    parts) { split(stem(file), parts, "_"); return parts[3] }
function confinement(file) { file = test_of(file); return sub(/^triaxial/, "", file) ? file + 0 : 0 }
