#include "post/report/minerals.hpp"

#include <algorithm>

#include "post/chart/labels.hpp"

namespace graincrack {

namespace {

using html::number;

std::string asked_for(const std::optional<Material>& material, const std::string& phase) {
    if (!material) return "";
    const auto found = material->fabric.phases.find(phase);
    return found == material->fabric.phases.end() ? "" : number(100 * found->second.fraction);
}

}  // namespace

std::string bounds_of(const GrainModuli& grains) {
    const std::string low = number(grains.reuss * 1e-9);
    const std::string high = number(grains.voigt * 1e-9);
    return low == high ? low : low + " to " + high;
}

void Minerals::add_phases(const std::string& kind, const Specimen& specimen, const RunHeader& header,
                          const std::optional<Material>& material) {
    if (specimen.phase_names.size() < 2) return;
    const std::vector<double> reached = phase_fractions(specimen);
    for (std::size_t p = 0; p < reached.size(); ++p) {
        const Phase& phase = header.fabric.phases.at(p);
        const auto grains = std::count(specimen.grain_phase.begin(), specimen.grain_phase.end(), p);
        phases_.row({p == 0 ? kind : " ", mineral_label(specimen.phase_names[p]), asked_for(material, specimen.phase_names[p]),
                     number(100 * reached[p]), std::to_string(grains), number(phase.young_modulus * 1e-9),
                     number(phase.poisson_ratio, 3), number(phase.density)});
    }
    const GrainModuli mean = grain_moduli(header, specimen);
    phases_.row({" ", "all, Reuss to Voigt", " ", "100", std::to_string(specimen.n_grains()), bounds_of(mean),
                 number(mean.poisson_ratio, 3), " "});
}

void Minerals::add_classes(const std::string& kind, const RunClasses& run) {
    if (run.classes.size() < 2) return;
    for (std::size_t k = 0; k < run.classes.size(); ++k) {
        const ClassCounts& each = run.classes[k];
        const ModeCounts peak = each.at_peak.value_or(ModeCounts{});
        classes_.row({k == 0 ? kind : " ", mineral_label(each.name), std::to_string(each.contacts),
                      number(100 * each.length / run.length(), 3), number(peak.tensile, 6), number(peak.shear, 6),
                      number(each.at_end.tensile, 6), number(each.at_end.shear, 6)});
    }
}

std::string Minerals::str() const {
    if (phases_.empty()) return "";
    return phases_.str() + (classes_.empty() ? "" : "<h3>Contacts and micro-cracks by class</h3>\n" + classes_.str());
}

}  // namespace graincrack
