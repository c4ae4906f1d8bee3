#include "mesher/mesh_settings.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace graincrack::mesher {
namespace {

using Numbers = std::vector<double>;
using Texts = std::vector<std::string>;

template <class Values>
void add(Settings& settings, const char* name, SettingGroup group, Values values, Dimension dimension = Dimension::one) {
    settings.push_back({name, values.empty() ? SettingValue() : SettingValue(std::move(values)), dimension, group});
}

void add_fabric(const Fabric& fabric, Settings& settings) {
    const std::optional<Grading>& grading = fabric.grading;
    add(settings, "grade", SettingGroup::fabric, grading ? name_of(grading->kind) : std::string());
    add(settings, "grade_relative_edges", SettingGroup::fabric, grading ? Numbers{grading->from, grading->to} : Numbers());
    add(settings, "grade_distance", SettingGroup::fabric, grading ? Numbers{grading->distance} : Numbers(), Dimension::length);
    Texts phases;
    Numbers fractions;
    for (const PhaseFraction& phase : fabric.phases.fractions) {
        phases.push_back(phase.name);
        fractions.push_back(phase.fraction);
    }
    add(settings, "phases", SettingGroup::material, std::move(phases));
    add(settings, "phase_fractions", SettingGroup::material, std::move(fractions));
}

std::string text_of(const FlawKind& kind) {
    const char* const state = starts_broken(static_cast<std::uint8_t>(kind.start)) ? "broken" : "intact";
    return kind.contact_class.empty() ? state : kind.contact_class + " " + state;
}

void add_flaws(const Request& request, Settings& settings) {
    Numbers flaws, lengths, persistences, dips;
    Texts classes, joint_classes;
    for (const PrescribedEdge& edge : request.region.edges) {
        if (edge.name == "--slit") continue;
        flaws.insert(flaws.end(), {edge.from.x, edge.from.y, edge.to.x, edge.to.y});
        classes.push_back(text_of(edge.kind));
    }
    for (const JointSet& set : request.joint_sets) {
        lengths.insert(lengths.end(), {set.spacing, set.length});
        dips.push_back(set.dip);
        persistences.push_back(set.persistence);
        joint_classes.push_back(text_of(set.kind));
    }
    add(settings, "flaws", SettingGroup::cuts, std::move(flaws), Dimension::length);
    add(settings, "flaw_classes", SettingGroup::cuts, std::move(classes));
    add(settings, "joint_spacing_and_length", SettingGroup::cuts, std::move(lengths), Dimension::length);
    add(settings, "joint_dip", SettingGroup::cuts, std::move(dips), Dimension::angle);
    add(settings, "joint_persistence", SettingGroup::cuts, std::move(persistences));
    add(settings, "joint_class", SettingGroup::cuts, std::move(joint_classes));
}

/// Adds the corners of a polygon, and the holes of regions except that of a ring.
void add_loops(const Region& region, Settings& settings) {
    Numbers corners, holes;
    Texts parts;
    for (std::size_t i = 0; i < region.loops.size(); ++i) {
        const Loop& loop = region.loops[i];
        if (i > 0 && loop.circle && region.name != "ring") {
            holes.insert(holes.end(), {loop.circle->centre.x, loop.circle->centre.y, loop.circle->radius});
        }
        if (i > 0 || region.name != "polygon") continue;
        for (const Point& corner : loop.corners) corners.insert(corners.end(), {corner.x, corner.y});
        for (const std::uint8_t part : loop.parts) parts.push_back(region.part_names[part]);
    }
    add(settings, "outline", SettingGroup::shape, std::move(corners), Dimension::length);
    add(settings, "outline_parts", SettingGroup::shape, std::move(parts));
    add(settings, "holes", SettingGroup::cuts, std::move(holes), Dimension::length);
}

}  // namespace

void add_settings(const Request& request, Settings& settings) {
    add_fabric(request.fabric, settings);
    add_loops(request.region, settings);
    add_flaws(request, settings);
}

}  // namespace graincrack::mesher
