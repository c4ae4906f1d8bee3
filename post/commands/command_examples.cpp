#include "post/commands/command_examples.hpp"

#include <array>
#include <map>

namespace graincrack {

namespace {

using Pair = std::array<const char*, 2>;

const std::map<std::string, Pair>& table_examples() {
    static const std::map<std::string, Pair> examples{
        {"info", {"uniaxial.h5", "disc.h5 --check"}},
        {"history", {"uniaxial.h5", "uniaxial.h5 --follow --format jsonl"}},
        {"strength", {"uniaxial.h5 brazilian.h5", "uniaxial.h5 triaxial.h5 brazilian.h5 --summary"}},
        {"moduli", {"uniaxial.h5", "uniaxial.h5 triaxial.h5 --format jsonl"}},
        {"toughness", {"notched-tension.h5", "notched-tension.h5 --format jsonl"}},
        {"envelope", {"uniaxial.h5 triaxial.h5", "uniaxial.h5 triaxial.h5 brazilian.h5 --capped accept"}},
        {"size-effect", {"brazilian-coarse.h5 brazilian.h5", "brazilian-coarse.h5 brazilian.h5 --capped accept --format jsonl"}},
        {"trend",
         {"strength.tsv --x mean_edge_mm --y tensile_strength_MPa --power",
          "strength.tsv --x contact_cohesion_MPa --y peak_compressive_stress_MPa --group confining_pressure_MPa"}},
        {"fpz", {"--material augig-granite", "--material augig-granite --format jsonl"}},
        {"cracks", {"uniaxial.h5 -o cracks", "brazilian.h5 --event-distance 10mm -o cracks"}},
        {"report", {"uniaxial.h5 -o page.html", "uniaxial.h5 triaxial.h5 brazilian.h5 --material augig-granite -o page.html"}},
        {"ccd design",
         {"--factor contact_cohesion_MPa=30:90 --factor contact_friction_angle_deg=45:61",
          "--factor contact_cohesion_MPa=30:90 --factor edge_mm=3:5 --star face-centred --centre-runs 3"}},
        {"ccd fit",
         {"table7.csv --response C_MPa --response phi_deg", "table7.csv --response C_MPa --model backward --table anova"}},
        {"ccd solve",
         {"table7.csv --target C_MPa=21 --target phi_deg=53",
          "table7.csv --target phi_deg=53 --maximise C_MPa=10:30 --model backward --alpha 0.05"}},
    };
    return examples;
}

const std::map<std::string, Pair>& picture_examples() {
    static const std::map<std::string, Pair> examples{
        {"plot specimen", {"disc.h5 -o disc.png", "uniaxial.h5 -o specimen.svg"}},
        {"plot curve", {"uniaxial.h5 triaxial.h5 -o curves.png", "uniaxial.h5 --laboratory measured.tsv -o curve.svg"}},
        {"plot strength",
         {"uniaxial.h5 brazilian.h5 -o strength.png", "uniaxial.h5 brazilian.h5 --material augig-granite -o strength.svg"}},
        {"plot cracks", {"brazilian.h5 --frame before,peak,after -o cracks.png", "uniaxial.h5 --magnify 10 -o cracks.svg"}},
        {"plot fragments", {"brazilian.h5 -o fragments.png", "uniaxial.h5 --frame peak -o fragments.svg"}},
        {"plot rosette", {"uniaxial.h5 -o rosette.png", "brazilian.h5 -o rosette.svg"}},
        {"plot counts", {"uniaxial.h5 -o counts.png", "brazilian.h5 -o counts.svg"}},
        {"plot emission", {"uniaxial.h5 -o emission.png", "uniaxial.h5 --event-distance 4mm -o emission.svg"}},
        {"plot energy", {"uniaxial.h5 -o energy.png", "brazilian.h5 -o energy.svg"}},
        {"plot thresholds", {"uniaxial.h5 -o thresholds.png", "triaxial.h5 -o thresholds.svg"}},
        {"plot envelope",
         {"uniaxial.h5 triaxial.h5 -o envelope.png", "uniaxial.h5 triaxial.h5 brazilian.h5 --capped accept -o envelope.svg"}},
        {"plot size-effect",
         {"brazilian-coarse.h5 brazilian.h5 -o size.png", "brazilian-coarse.h5 brazilian.h5 --capped accept -o size.svg"}},
        {"plot surface",
         {"table7.csv --target C_MPa=21 --target phi_deg=53 -o surface.png",
          "table7.csv --target C_MPa=21 --target phi_deg=53 --model backward -o surface.svg"}},
        {"plot law", {"--material augig-granite -o law.png", "uniaxial.h5 --normal-stress 50MPa -o law.svg"}},
        {"plot lennard-jones", {"-o potential.png", "-o potential.svg"}},
        {"plot trend",
         {"strength.tsv --x mean_edge_mm --y tensile_strength_MPa --power -o trend.png",
          "strength.tsv --x contact_cohesion_MPa --y peak_compressive_stress_MPa --group test -o trend.svg"}},
        {"plot table",
         {"strength.tsv --x mean_edge_mm --y tensile_strength_MPa --points -o table.png",
          "strength.tsv --x strain_at_peak --y tensile_cracks --y shear_cracks --points -o table.svg"}},
    };
    return examples;
}

}  // namespace

std::string command_examples(const std::string& command) {
    const auto& examples = command.starts_with("plot ") ? picture_examples() : table_examples();
    std::string lines;
    for (const char* arguments : examples.at(command)) lines += "  graincrack-post " + command + " " + arguments + "\n";
    return lines;
}

}  // namespace graincrack
