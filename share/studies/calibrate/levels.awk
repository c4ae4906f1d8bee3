# strength.tsv of discs to level, seed and strength. Set by -v: parameter, the token that varies (tc, gf, os); none: level 0.
BEGIN { FS = "\t"; print "level\tseed\ttensile_strength_MPa" }
FNR == 1 { head(); next }
{ print (parameter == "" ? 0 : token(value("file"), parameter)) "\t" seed_of(value("file")) "\t" value("tensile_strength_MPa") }
