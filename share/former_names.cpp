#include "share/former_names.hpp"

#include <algorithm>
#include <array>

#include "share/schema.hpp"

namespace graincrack {
namespace {

/// A dataset or attribute with another name since schema 2.
struct FormerName {
    std::string_view group, now, before;
};
constexpr std::array names_of_schema_1{
    FormerName{schema::run_group, "energy_balance_error", "ledger_residual"},
    FormerName{schema::run_group, "energy_balance_error_unit", "ledger_residual_unit"},
    FormerName{schema::history_group, "energy_balance_error", "ledger_residual"},
    FormerName{schema::history_group, "non_conservative_work", "law_mismatch"},
    FormerName{schema::program_group, "start_amplitudes", "start_controls"},
    FormerName{schema::program_group, "start_amplitude_values", "start_control_values"},
    FormerName{schema::state_group, "amplitudes", "controls"},
    FormerName{schema::state_group, "amplitude_values", "control_values"},
    FormerName{schema::state_group, "energy_balance_error", "energy_imbalance"},
    FormerName{schema::state_group, "integrity", "cohesion_left"},
    FormerName{schema::state_group, "residual", "spent"},
    FormerName{schema::state_group, "debonded", "touch_loose"},
    FormerName{schema::state_group, "released", "touch_released"},
    FormerName{schema::state_group, "candidate_pairs", "touch_pairs"},
    FormerName{schema::state_group, "node_edge_contacts", "touches"},
    FormerName{schema::state_group, "pair_forces", "touch_forces"},
    FormerName{schema::state_group, "pair_groups", "touch_groups"},
    FormerName{schema::state_group, "watched_pairs", "touch_awake"},
    FormerName{schema::state_group, "watched_groups", "touch_awake_groups"},
    FormerName{schema::state_group, "watched_chunks", "touch_blocks"},
    FormerName{schema::state_group, "pair_friction", "touch_friction"},
    FormerName{schema::state_group, "pair_friction_before", "touch_friction_before"},
    FormerName{schema::state_group, "displacement_at_search", "touch_displacement_at_search"},
    FormerName{schema::state_group, "occupied_area", "touch_area_taken"},
    FormerName{schema::state_group, "next_list_update", "touch_next_check"},
    FormerName{schema::state_group, "wants_rebuild", "touch_wants_search"},
    FormerName{schema::state_group, "travel_since_rebuild", "touch_way_unsearched"},
    FormerName{schema::state_group, "detection_interval", "touch_review_interval"},
    FormerName{schema::state_group, "cluster_energies", "group_energies"},
};

/// An attribute with another text since schema 2.
struct FormerText {
    std::string_view group, attribute, now, before;
};
constexpr std::array texts_of_schema_1{
    FormerText{schema::run_group, "stop_reason", "strain limit", "strain cap"},
    FormerText{schema::program_group, "ended_by", "strain limit", "strain cap"},
    FormerText{schema::state_group, "stages_ended_by", "strain limit", "strain cap"},
};

}  // namespace

std::string_view stored_name(std::int64_t version, std::string_view group, std::string_view name) {
    const auto row = std::find_if(names_of_schema_1.begin(), names_of_schema_1.end(),
                                  [&](const FormerName& f) { return f.group == group && f.now == name; });
    return version >= 2 || row == names_of_schema_1.end() ? name : row->before;
}

std::vector<std::pair<std::string_view, std::string_view>> former_names_of(std::string_view group) {
    std::vector<std::pair<std::string_view, std::string_view>> names;
    for (const FormerName& name : names_of_schema_1) {
        if (name.group == group) {
            names.emplace_back(name.now, name.before);
        }
    }
    return names;
}

std::string_view present_text(std::int64_t version, std::string_view group, std::string_view attribute, std::string_view text) {
    const auto row = std::find_if(texts_of_schema_1.begin(), texts_of_schema_1.end(), [&](const FormerText& f) {
        return f.group == group && f.attribute == attribute && f.before == text;
    });
    return version >= 2 || row == texts_of_schema_1.end() ? text : row->now;
}

}  // namespace graincrack
