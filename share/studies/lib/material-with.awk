# A material file with other values. Comments on the changed lines have the former value.
# Set by -v: set, as in "rock.young_modulus=26.9 GPa;contact.cohesion=70 MPa"; name, of the new material.
BEGIN {
    n = split(set, pairs, ";")
    for (i = 1; i <= n; ++i) {
        split(pairs[i], sides, "=")
        split(sides[1], parts, ".")
        value[sides[1]] = sides[2]
        keys[parts[1]] = keys[parts[1]] " " parts[2]
    }
}
/^[ \t]*\[/ { finish(); section = $0; sub(/#.*/, "", section); gsub(/[][ \t]/, "", section) }
section == "" && /^name[ \t]*=/ && name != "" { print "name = \"" name "\""; next }
/^[ \t]*[a-z_]+[ \t]*=/ {
    key = $0
    sub(/[ \t]*=.*/, "", key)
    sub(/^[ \t]*/, "", key)
    if ((section "." key) in value) {
        old = $0
        sub(/^[^=]*=[ \t]*/, "", old)
        sub(/[ \t]*#.*/, "", old)
        line(section "." key, "was " old)
        next
    }
}
{ print }
END { finish() }
function line(full, comment) {
    text = value[full]
    if (text ~ /[^-+0-9.eE]/) text = "\"" text "\""
    key = full
    sub(/^[^.]*\./, "", key)
    printf "%-39s # %s\n", key " = " text, comment
    done[full] = 1
}
# Adds the keys that the section just ended does not have.
function finish(    i, n, names) {
    n = split(keys[section], names, " ")
    for (i = 1; i <= n; ++i) if (!((section "." names[i]) in done)) line(section "." names[i], "added")
}
