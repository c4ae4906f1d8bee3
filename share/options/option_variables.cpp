#include "share/options/option_variables.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "share/base/toml_file.hpp"

namespace graincrack {
namespace {

constexpr std::string_view prefix = "GRAINCRACK_";

constexpr const char* option_list =
    "--alpha --block-speed --block-steps --by --capped --centre-runs --check --checkpoint-every --class --colour "
    "--confining-pressure --contact-cohesion --contact-friction-angle --contact-law "
    "--contact-normal-stiffness --contact-open-shear-strength --contact-residual-cohesion "
    "--contact-residual-friction-angle --contact-residual-tensile-strength --contact-shear-stiffness "
    "--contact-tensile-strength --coupling --crack-event --crack-mode --crystals --damping --damping-form --definitions "
    "--diameter "
    "--diameters --digest --discard-checkpoint --dpi --dry-run --duration --edge --element-size --elements-per-crystal "
    "--elements-per-edge "
    "--elongation "
    "--elongation-angle "
    "--event-distance --event-time "
    "--extrapolate --flats --flaws --hole --holes --inner-diameter --jagged --joint-set --length --notch-angle --slit "
    "--slit-angle "
    "--factor --follow --format --fracture-energy --frame --frames --frames-per-second --grade --grain --grain-size --grains "
    "--group --height "
    "--kind --label "
    "--laboratory --list "
    "--loaded-diameter --magnify --mass-scaling --mass-scaling-factor --material --materials --max-strain "
    "--maximise --minimise --mode-ii-fracture-energy --model --normal-stress --notch --open-boundaries --open-seed --origin "
    "--output --paraview --peak-drop "
    "--phase-cluster --phase-key --phase-seed --phases --pivot --pixel-size --plane --platen-friction --points --pole --power "
    "--print-program "
    "--probe "
    "--program "
    "--quiet --rate --rebalance "
    "--rate-share --rate-tolerance --response --restart --roller-width --save-state --scale --seed --sensitivity --set --shape "
    "--size --size-distribution --smallest-piece "
    "--span --spread --sql --stages --star --strength --strength-correlation --strength-modulus --strength-seed --study "
    "--summary "
    "--table --tessellation "
    "--target --threads --time "
    "--time-step-fraction --title --unit --vector --verbose --walltime --width --write-key --x --x-limits --y --y-limits";

std::string option_of(std::string_view variable) {
    std::string option(variable.substr(prefix.size()));
    for (char& c : option) c = c == '_' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return option;
}

}  // namespace

const std::vector<std::string>& options_of_all_tools() {
    static const std::vector<std::string> options = [] {
        std::vector<std::string> names;
        std::istringstream list(option_list);
        for (std::string name; list >> name;) names.push_back(name.substr(2));
        return names;
    }();
    return options;
}

std::string variable_of(const std::string& option) {
    std::string variable(prefix);
    for (const char c : option) variable += c == '-' ? '_' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return variable;
}

std::vector<std::string> misspelt_variables() {
    const std::vector<std::string>& known = options_of_all_tools();
    std::vector<std::string> sentences;
    for (char** each = environ; *each != nullptr; ++each) {
        std::string_view name(*each);
        name = name.substr(0, name.find('='));
        if (!name.starts_with(prefix)) continue;
        const std::string option = option_of(name);
        if (std::find(known.begin(), known.end(), option) != known.end()) continue;
        const std::string nearest = nearest_word(option, known);
        if (nearest.empty()) continue;
        sentences.push_back(fmt::format("{}: no option has this variable, so that it does nothing; did you mean {}?", name,
                                        variable_of(nearest)));
    }
    std::sort(sentences.begin(), sentences.end());
    return sentences;
}

}  // namespace graincrack
