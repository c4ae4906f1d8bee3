# Prints one value of a material file as a bare number: stresses in MPa, angles in degrees, lengths in mm, toughnesses in
# MPa√m, energies in J/m², the rest as in the file. Nothing if the file has no such key.
# Set by -v: key, as in laboratory.compressive_strength.
BEGIN { split(key, wanted, ".") }
{ sub(/#.*/, "") }
/^[ \t]*\[/ { section = $0; gsub(/[][ \t]/, "", section); next }
index($0, "=") {
    name = substr($0, 1, index($0, "=") - 1)
    gsub(/[ \t]/, "", name)
    if (section != wanted[1] || name != wanted[2]) next
    value = substr($0, index($0, "=") + 1)
    gsub(/"/, "", value)
    n = split(value, parts, " ")
    if (n == 1 && match(value, /[a-zA-Z][a-zA-Z0-9\/.^]*$/) && value !~ /^[ \t]*[-+0-9.]+[eE][-+]?[0-9]+$/) {
        parts[2] = substr(value, RSTART)  # "4mm"
        parts[1] = substr(value, 1, RSTART - 1)
    }
    printf "%.6g\n", in_table_units(name, parts[1] + 0, parts[2])
}
function in_table_units(name, number, unit) {
    if (unit ~ /^kPa/) return number / 1e3
    if (unit ~ /^GPa/) return number * 1e3
    if (unit ~ /^MPa/ || unit == "deg" || unit == "mm") return number
    if (unit ~ /^Pa/) return number / 1e6
    if (unit == "rad") return number * 45 / atan2(1, 1)
    if (unit == "cm") return number * 10
    if (unit == "m") return number * 1e3
    if (unit == "um") return number / 1e3
    if (unit == "kJ/m2") return number * 1e3
    if (unit != "") return number
    if (name ~ /strength|cohesion|modulus|toughness/) return number / 1e6
    if (name ~ /angle/) return number * 45 / atan2(1, 1)
    if (name ~ /size/) return number * 1e3
    return number
}
