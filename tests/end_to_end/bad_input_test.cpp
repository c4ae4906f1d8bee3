// Bad input ends with its exit code and one line that names the fault, and leaves no file.
#include <vector>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

struct BadInput {
    const char* name;
    const char* command;
    int exit_code;
    const char* named;  ///< what the line must name: the option, file or word at fault
};
void PrintTo(const BadInput& bad, std::ostream* stream) { *stream << "exit " << bad.exit_code; }

class Refused : public testing::TestWithParam<BadInput> {};

/// Files for the commands below, good and bad ones of each kind. A run is made only for commands that use one.
void lay_out(const Shell& shell, const std::string& command) {
    std::string lines = make_disc + "disc.h5\nhead -c 20000 disc.h5 >truncated.h5\necho text >text.h5\n: >empty.h5\n";
    lines += "material=" GRAINCRACK_SOURCE "/share/materials/augig-granite.toml\n";
    lines += "grep -v '^density' $material >no-density.toml\n";
    lines += "echo 'gravity = 1' >unknown-key.toml\n";
    const std::string flaws = "printf 'x1_mm\\ty1_mm\\tx2_mm\\ty2_mm\\tclass\\n";
    lines += flaws + "0\\t0\\t4\\t0\\t\\n20\\t0\\t30\\t0\\t\\n' >outside.tsv\n";
    lines += flaws + "0\\t0\\t4\\t0\\tbroken\\n2\\t0\\t6\\t0\\tbroken\\n' >double.tsv\n";
    lines += flaws + "0\\t0\\t4\\t0\\tHealed\\n' >class.tsv\n";
    lines += "printf 'x_mm\\ty_mm\\n0\\t0\\n20\\t20\\n20\\t0\\n0\\t20\\n' >cross.tsv\n";
    if (command.find("rectangle.h5") != std::string::npos) {
        lines += "graincrack-mesh rectangle --width 20mm --height 40mm --grains 60 --quiet -o rectangle.h5\n";
    }
    if (command.find("beam.h5") != std::string::npos) {
        lines += "graincrack-mesh beam --length 30mm --height 10mm --edge 5mm --quiet -o beam.h5\n";
    }
    if (command.find("run.h5") != std::string::npos) {
        lines += "graincrack-solve brazilian disc.h5 -o run.h5" + elastic + "\n";
        lines += "size=$(stat -c %s run.h5)\nhead -c $((size * 3 / 4)) run.h5 >truncated-run.h5\n";
    }
    shell.must(lines);
}

TEST_P(Refused, WithCodeAndOneLine) {
    const BadInput& bad = GetParam();
    const Shell shell;
    lay_out(shell, bad.command);
    const std::string before = shell.names();
    const Outcome outcome = shell.run(bad.command);
    EXPECT_EQ(outcome.exit_code, bad.exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(bad.named), std::string::npos) << outcome.err;
    const std::string command = bad.command;
    const std::size_t tool = command.find("graincrack-");
    EXPECT_TRUE(outcome.err.starts_with(command.substr(tool, command.find(' ', tool) - tool) + ": ")) << outcome.err;
    EXPECT_EQ(shell.names(), before);
}

std::string name_of_case(const testing::TestParamInfo<BadInput>& info) { return info.param.name; }

#define MESH_4MM "graincrack-mesh rectangle --width 80mm --height 160mm --edge 4mm "
const std::vector<BadInput> mesher{
    {"WrongUnit", "graincrack-mesh disc --diameter 20kg --grains 60 -o out.h5", 2, "--diameter"},
    {"NoSize", "graincrack-mesh disc --diameter 20mm -o out.h5", 2, "--edge"},
    {"EdgeBeyondTheShape", "graincrack-mesh disc --diameter 20mm --edge 1m -o out.h5", 2, "--edge"},
    {"NoOutput", "graincrack-mesh disc --diameter 20mm --grains 60", 2, "-o"},
    {"MissingFolder", "graincrack-mesh disc --diameter 20mm --grains 60 -o nowhere/out.h5", 5, "nowhere"},
    {"EndlessMaterial", "graincrack-solve brazilian disc.h5 --material /dev/zero -o out.h5", 3,
     "/dev/zero: has more than the 16 MB that are read at most"},
    {"EndlessSpecimen", "graincrack-solve brazilian /dev/zero --material augig-granite -o out.h5", 3,
     "/dev/zero: has more than the 512 MB that are read at most"},
    {"EndlessConfiguration", "graincrack-solve brazilian disc.h5 --config /dev/zero --material augig-granite -o out.h5", 2,
     "16 MB"},
    {"WideRollers", "graincrack-solve bend beam.h5 --roller-width 40mm --material augig-granite -o out.h5", 2,
     "--roller-width: three rollers 40 mm wide have no room on a beam of 30 mm; at most 10 mm fits"},
    {"EnergyBeyondItsBound",
     "graincrack-solve uniaxial disc.h5 --material augig-granite --contact-normal-stiffness 1e3 --fracture-energy 1e9 -o out.h5",
     2, "give a stiffer contact, or one of less strength"},
    {"MissingMaterial", "graincrack-mesh disc --diameter 20mm --grains 60 --material cheese -o out.h5", 3, "cheese"},
    {"MaterialMissesAProperty", "graincrack-mesh disc --diameter 20mm --grains 60 --material no-density.toml -o out.h5", 3,
     "density"},
    {"FlawOutside", "graincrack-mesh disc --diameter 20mm --grains 200 --flaws outside.tsv -o out.h5", 2, "outside.tsv: line 3"},
    {"FlawsUponEachOther", "graincrack-mesh disc --diameter 20mm --grains 200 --flaws double.tsv -o out.h5", 2,
     "double.tsv: line 3: lies upon double.tsv: line 2"},
    {"FlawOfUnknownClass", "graincrack-mesh disc --diameter 20mm --grains 200 --flaws class.tsv -o out.h5", 3,
     "class.tsv: line 2"},
    {"FlawsWithoutRows", "graincrack-mesh disc --diameter 20mm --grains 200 --flaws text.h5 -o out.h5", 3, "text.h5: no rows"},
    {"MissingFlaws", "graincrack-mesh disc --diameter 20mm --grains 200 --flaws none.tsv -o out.h5", 3, "none.tsv"},
    {"PolygonWhoseSidesCross", "graincrack-mesh polygon cross.tsv --grains 200 -o out.h5", 3, "cross.tsv"},
    {"HoleAcrossTheRim", "graincrack-mesh disc --diameter 20mm --grains 200 --hole 8mm,0,4mm -o out.h5", 2, "--hole"},
    {"SecondHoleInTheFirst", "graincrack-mesh disc --diameter 20mm --grains 200 --hole 0,0,4mm --hole 1mm,0,1mm -o out.h5", 2,
     "--hole 2"},
    {"HoleOfTwoNumbers", "graincrack-mesh disc --diameter 20mm --grains 200 --hole 1mm,2mm -o out.h5", 2, "--hole"},
    {"SlitWithoutRoom", "graincrack-mesh disc --diameter 20mm --grains 200 --slit 21mm -o out.h5", 2, "--slit"},
    {"AngleWithoutASlit", "graincrack-mesh disc --diameter 20mm --grains 200 --slit-angle 20deg -o out.h5", 2, "--slit-angle"},
    {"JointsWithoutDip", "graincrack-mesh disc --diameter 20mm --grains 200 --joint-set spacing=5mm -o out.h5", 2, "dip"},
    {"JointsTooClose", "graincrack-mesh disc --diameter 20mm --edge 2mm --joint-set spacing=1mm,dip=0 -o out.h5", 2,
     "--joint-set"},
    {"HoleOfFewGrains", "graincrack-mesh disc --diameter 20mm --edge 2mm --hole 0,0,1mm -o out.h5", 2, "--edge"},
    {"RingWithoutRock", "graincrack-mesh ring --diameter 20mm --inner-diameter 20mm --edge 2mm -o out.h5", 2, "--inner-diameter"},
    {"EdgeOfTheShape", "graincrack-mesh rectangle --width 80mm --height 160mm --edge 90mm -o out.h5", 2, "--edge"},
    {"FewGrains", "graincrack-mesh rectangle --width 80mm --height 160mm --grains 3 -o out.h5", 2, "--grains"},
    {"SpreadOfTriangles", MESH_4MM "--spread 0.4 -o out.h5", 2, "--spread"},
    {"GradeWithoutRange", MESH_4MM "--grade along=y -o out.h5", 2, "--grade"},
    {"GradeBeyondARatio", MESH_4MM "--grade along=y,from=0.01,to=1 -o out.h5", 2, "from"},
    {"GradeTowardsNoFlaw", MESH_4MM "--grade towards=flaws,from=0.5,distance=20mm -o out.h5", 2, "no flaw"},
    {"GradeOverAnEdge", MESH_4MM "--grade towards=boundary,from=0.2,distance=4mm -o out.h5", 2, "distance"},
    {"HoleOfPolygons", MESH_4MM "--tessellation voronoi --hole 0mm,0mm,2mm -o out.h5", 2, "--edge"},
    {"ShortNotch", MESH_4MM "--tessellation voronoi --slit 1mm -o out.h5", 2, "--slit"},
    {"SpreadOfPolygons", MESH_4MM "--tessellation trigon --spread 0.7 -o out.h5", 2, "--spread"},
    {"DivisionsOfPolygons", MESH_4MM "--tessellation trigon --elements-per-edge 2 -o out.h5", 2, "--elements-per-edge"},
    {"SizesOfPolygons", MESH_4MM "--tessellation voronoi --size-distribution even -o out.h5", 2, "--size-distribution"},
    {"ElementsOfTriangles", MESH_4MM "--element-size 1mm -o out.h5", 2, "--element-size"},
    {"PhasesBeyondTheArea", MESH_4MM "--phases quartz=0.6,mica=0.5 -o out.h5", 2, "--phases"},
    {"PhaseWithoutFraction", MESH_4MM "--phases quartz -o out.h5", 2, "--phases"},
    {"ClusterOfNoPhases", MESH_4MM "--phase-cluster 3 -o out.h5", 2, "--phase-cluster"},
    {"SeedOfNoPhases", MESH_4MM "--phase-seed 3 -o out.h5", 2, "--phase-seed"},
    {"CorrelationOfNoStrengths", MESH_4MM "--strength-correlation 10mm -o out.h5", 2, "--strength-correlation"},
    {"NoModulus", MESH_4MM "--strength-modulus 0 -o out.h5", 2, "--strength-modulus"},
    {"AllOpen", MESH_4MM "--open-boundaries 1 -o out.h5", 2, "--open-boundaries"},
    {"SeedOfNoOpenBoundaries", MESH_4MM "--open-seed 3 -o out.h5", 2, "--open-seed"},
};
INSTANTIATE_TEST_SUITE_P(Mesher, Refused, testing::ValuesIn(mesher), name_of_case);

const std::vector<BadInput> solver{
    {"RateThatIsNone", "graincrack-solve brazilian disc.h5 --material augig-granite --rate automatic -o out.h5", 2, "--rate"},
    {"RateShareOfAFixedRate",
     "graincrack-solve brazilian disc.h5 --material augig-granite --rate 5mm/s --rate-share 0.5 -o out.h5", 2, "--rate-share"},
    {"ToleranceOfAFixedRate",
     "graincrack-solve brazilian disc.h5 --material augig-granite --rate 5mm/s --rate-tolerance 0.001 -o out.h5", 2,
     "--rate-tolerance"},
    {"BlocksOfAnAutomaticRate", "graincrack-solve brazilian disc.h5 --material augig-granite --block-steps 500 -o out.h5", 2,
     "--block-steps"},
    {"MissingFile", "graincrack-solve brazilian none.h5 --material augig-granite -o out.h5", 3, "none.h5"},
    {"TruncatedFile", "graincrack-solve brazilian truncated.h5 --material augig-granite -o out.h5", 3, "truncated.h5"},
    {"TruncatedPipe", "cat truncated.h5 | graincrack-solve brazilian - --material augig-granite -o out.h5", 3, "stdin"},
    {"TextFile", "graincrack-solve brazilian text.h5 --material augig-granite -o out.h5", 3, "text.h5"},
    {"EmptyFile", "graincrack-solve brazilian empty.h5 --material augig-granite -o out.h5", 3, "empty.h5"},
    {"Folder", "graincrack-solve brazilian . --material augig-granite -o out.h5", 3, "folder"},
    {"EmptyStdin", "graincrack-solve brazilian - --material augig-granite -o out.h5", 3, "the program before wrote nothing"},
    {"RunAsSpecimen", "graincrack-solve brazilian run.h5 --material augig-granite -o out.h5", 3, "specimen"},
    {"MissingMaterial", "graincrack-solve brazilian disc.h5 --material cheese -o out.h5", 3, "cheese"},
    {"MaterialMissesAProperty", "graincrack-solve brazilian disc.h5 --material no-density.toml -o out.h5", 3, "density"},
    {"NoMaterial", "graincrack-solve brazilian disc.h5 -o out.h5", 2, "--material"},
    {"UnknownKey", "graincrack-solve brazilian disc.h5 --material augig-granite --config unknown-key.toml -o out.h5", 2,
     "gravity"},
    {"MissingFolder", "graincrack-solve brazilian disc.h5 --material augig-granite -o nowhere/out.h5", 5, "nowhere"},
    {"UnknownOption", "graincrack-solve brazilian disc.h5 --material augig-granite --speed 5mm/s -o out.h5", 2, "--speed"},
    {"StrainLimitThatThePressureTakesUp",
     "graincrack-solve triaxial rectangle.h5 --material augig-granite --confining-pressure 1GPa --max-strain 0.005 --quiet -o "
     "out.h5",
     2, "--max-strain"},
    {"BridgesWithoutEnergy",
     "graincrack-solve brazilian disc.h5 --material augig-granite --contact-bridging-strength 5MPa -o out.h5", 3,
     "bridging_energy is 0"},
    {"UnknownLaw", "graincrack-solve brazilian disc.h5 --material augig-granite --contact-law scaled -o out.h5", 2,
     "cohesive-frictional"},
    {"ParameterOfAnotherLaw",
     "graincrack-solve brazilian disc.h5 --material augig-granite --contact-residual-cohesion 3MPa -o out.h5", 2,
     "--contact-residual-cohesion: the contact law consistent does not use it; leave it out, or choose a law that uses it: "
     "coulomb-slip"},
    {"EnergyOfALawWithout",
     "graincrack-solve brazilian disc.h5 --material augig-granite --contact-law coulomb-slip --fracture-energy mixed -o out.h5",
     2, "--fracture-energy: the contact law coulomb-slip does not use it"},
    {"MixedEnergyOfTwoModes",
     "graincrack-solve brazilian disc.h5 --material augig-granite --contact-law combined --fracture-energy mixed -o out.h5", 2,
     "mode-i or a value fits"},
    {"FractureEnergyTooSmallForThePeak",
     "graincrack-solve uniaxial disc.h5 --material augig-granite --fracture-energy 1J/m2 -o out.h5", 2,
     "--fracture-energy: 1 J/m2 is less than a contact of the law consistent absorbs up to its peak; give at least 1.657 J/m2"},
    {"ModeTwoEnergyTooSmallForThePeak",
     "graincrack-solve uniaxial disc.h5 --material augig-granite --contact-law combined --contact-shear-stiffness 1e12 -o out.h5",
     2, "--mode-ii-fracture-energy: 330.4 J/m2 is less"},
    {"FactorWithoutMassScaling",
     "graincrack-solve brazilian disc.h5 --material augig-granite --mass-scaling none --mass-scaling-factor 50 -o out.h5", 2,
     "--mass-scaling-factor"},
    {"RectangleAsDisc", "graincrack-solve brazilian rectangle.h5 --material augig-granite -o out.h5", 3,
     "rectangle.h5: is a rectangle"},
    {"DiscAsRectangle", "graincrack-solve uniaxial disc.h5 --material augig-granite -o out.h5", 3, "disc.h5: is a disc"},
    {"DiscInTension", "graincrack-solve tension disc.h5 --material augig-granite --dry-run", 3, "disc.h5: is a disc"},
    {"DiscUnderPressure", "graincrack-solve triaxial disc.h5 --material augig-granite --confining-pressure 4MPa --print-program",
     3, "disc.h5: is a disc"},
    {"RectangleThatIsBent", "graincrack-solve bend rectangle.h5 --material augig-granite -o out.h5", 3,
     "a bend test loads a beam or a half-disc"},
    {"SpanBeyondABeam", "graincrack-solve bend beam.h5 --span 30mm --material augig-granite -o out.h5", 2,
     "--span: rollers at a distance of 30 mm have no room on a beam of 30 mm"},
    {"ShortBeamWithoutSpan", "graincrack-solve bend beam.h5 --material augig-granite -o out.h5", 2, "--span: missing"},
    {"CoolWithoutHeat", "graincrack-solve brazilian disc.h5 --cool --material augig-granite -o out.h5", 2,
     "--cool: there is nothing to cool; give --heat"},
    {"HeatPastQuartz", "graincrack-solve brazilian disc.h5 --heat 600K --material augig-granite -o out.h5", 2,
     "at 573 deg C quartz changes"},
    {"HeatWithoutExpansion", "graincrack-solve brazilian disc.h5 --heat 300K --material augig-granite -o out.h5", 3,
     "--heat: changes the temperature, and no phase of the material"},
    {"SpanOfAnotherTest", "graincrack-solve brazilian disc.h5 --span 10mm --material augig-granite -o out.h5", 2, "--span"},
};
INSTANTIATE_TEST_SUITE_P(Solver, Refused, testing::ValuesIn(solver), name_of_case);

const std::vector<BadInput> postprocessor{
    {"MissingFile", "graincrack-post strength none.h5", 3, "none.h5"},
    {"TruncatedFile", "graincrack-post info truncated.h5", 3, "truncated.h5"},
    {"TruncatedRun", ": run.h5; graincrack-post strength truncated-run.h5", 3, "truncated-run.h5"},
    {"TextFile", "graincrack-post info text.h5", 3, "text.h5"},
    {"EmptyStdin", "graincrack-post strength -", 3, "the program before wrote nothing"},
    {"TwoStdins", "graincrack-post strength - -", 2, "stdin"},
    {"SpecimenAsRun", "graincrack-post strength disc.h5", 3, "disc.h5"},
    {"MapsOfASpecimen", "graincrack-post cracks disc.h5 -o maps", 3, "disc.h5"},
    {"MeshOfAnotherEnding", "graincrack-post export disc.h5 -o disc.stl", 2,
     "--output disc.stl: its name must end in .msh or .vtu, or --format"},
    {"MeshToStdoutWithoutFormat", "graincrack-post export disc.h5 -o -", 2, "--output -: the format is missing"},
    {"MeshOfTwoFormats", "graincrack-post export disc.h5 -o disc.vtu --format gmsh", 2, "--output disc.vtu: ends in .vtu"},
    {"MeshOfAText", "graincrack-post export text.h5 -o mesh.msh", 3, "text.h5"},
    {"MeshOfTwoSpecimens", "graincrack-post export disc.h5 disc.h5 -o mesh.msh", 2, "export: takes one file, not 2"},
    {"MeshInAMissingFolder", "graincrack-post export disc.h5 -o nowhere/mesh.msh", 5, "nowhere"},
    {"EnvelopeOfADisc", "graincrack-post envelope run.h5", 3, "run.h5"},
    {"EnvelopeOfNothing", "graincrack-post envelope --files-from text.h5", 3, "no"},
    {"ListAndFileFromStdin", "echo run.h5 | graincrack-post strength - --files-from -", 2, "--files-from"},
    {"AQueryIsStopped",
     "timeout -k 20 --preserve-status 2 graincrack-post summarize double.tsv --sql "
     "\"SELECT count(*) FROM $(seq -f 'double d%g' -s , 40)\"",
     143, "stopped by signal 15"},
    {"MissingList", "graincrack-post strength --files-from none.txt", 3, "none.txt"},
    {"SizeEffectOfOneSize", "graincrack-post size-effect run.h5 --strength largest --capped accept", 3, "two or more edges"},
    {"DesignWithoutFactors", "graincrack-post ccd design", 2, "--factor"},
    {"FactorWithoutRange", "graincrack-post ccd design --factor cc=3", 2, "cc=3"},
    {"FitOfARun", "graincrack-post ccd fit run.h5 --response C_MPa", 3, "run.h5"},
    {"SolveWithoutGoal", "graincrack-post ccd solve text.h5", 2, "--target"},
    {"FollowNothing", "graincrack-post history none.h5 --follow", 3, "none.h5"},
    {"ReportOfASpecimen", "graincrack-post report disc.h5 -o page.html", 3, "disc.h5"},
    {"ReportThatIsItsView", "graincrack-post report run.h5 --view page.html -o page.html", 2, "--view page.html: is the report"},
    {"ViewOfASpecimen", "graincrack-post view disc.h5 -o view.html", 3, "disc.h5"},
    {"ViewOfAnotherEnding", "graincrack-post view run.h5 -o view.htm", 2, "view.htm: its name must end in .html"},
    {"LawOfNothing", "graincrack-post plot law -o law.png", 2, "--material"},
    {"UnknownLaw", "graincrack-post plot law --material augig-granite --contact-law newton -o law.png", 2, "newton"},
    {"ThresholdsOfADisc", "graincrack-post plot thresholds run.h5 -o t.png", 3, "brazilian"},
    {"MissingMaterial", "graincrack-post fpz --material cheese", 3, "cheese"},
    {"MaterialMissesAProperty", "graincrack-post plot law --material no-density.toml -o law.png", 3, "density"},
    {"RockWithoutAModulus", "printf 'name = \"x\"' | graincrack-post fpz --material /dev/stdin", 3, "young_modulus"},
    {"TemplateOverAFile", "graincrack-post material init no-density", 5, "no-density.toml: exists"},
    {"ValueNotThere", "graincrack-post material value contact.residual_cohesion augig-granite", 3, "augig-granite.toml: has no"},
    {"ValueInMillimetres", "graincrack-post material value contact.cohesion augig-granite --unit mm", 2, "stress; one of Pa"},
    {"MissingFolder", "graincrack-post plot cracks run.h5 -o nowhere/out.png", 5, "nowhere"},
    {"AFileForAFolder", "graincrack-post cracks run.h5 -o text.h5", 5, "text.h5"},
    {"UnknownPicture", "graincrack-post plot cracks run.h5 -o out.gif", 2, "out.gif"},
    {"FramesOfASpecimen", "graincrack-post plot cracks disc.h5 --frame all -o frames", 3, "disc.h5"},
    {"FramesInAFile", "graincrack-post plot cracks run.h5 --frame all -o out.png", 2, "out.png: --frame all writes numbered"},
    {"FramesToStdout", "graincrack-post plot cracks run.h5 --frame all -o -", 2, "the name of a folder fits"},
    {"FramesInAMissingFolder", "graincrack-post plot cracks run.h5 --frame all -o nowhere/frames", 5, "nowhere"},
    {"FramesInAFolderOfOthers", "graincrack-post plot cracks run.h5 --frame all -o .", 5, "which is no numbered picture"},
    {"MissingFrame", "graincrack-post plot cracks run.h5 --frame 9999 -o out.png", 2, "--frame"},
    {"NoFile", "graincrack-post strength", 2, "runs"},
    {"WordForAnother", "graincrack-post strength run.h5 --format xml", 2, "xml"},
};
INSTANTIATE_TEST_SUITE_P(Postprocessor, Refused, testing::ValuesIn(postprocessor), name_of_case);

}  // namespace
}  // namespace graincrack::test
