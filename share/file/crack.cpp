#include "share/file/crack.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <type_traits>

#include "share/file/datasets.hpp"
#include "share/file/file_checks.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

namespace {

/// Calls `visit(dataset, member, may_be_nan)` for each column, in the order of the file; `std::invoke` applies the member to a
/// crack.
template <class Visit>
void visit_columns(const Visit& visit) {
    visit(schema::crack_time, &Crack::time, false);
    visit(schema::crack_step, &Crack::step, false);
    visit(schema::crack_contact, &Crack::contact, false);
    visit(schema::crack_point, &Crack::point, false);
    visit(schema::crack_mode, &Crack::mode, false);
    visit(schema::crack_mode_angle, &Crack::mode_angle, false);
    visit(schema::crack_position, &Crack::position, false);
    visit(schema::crack_orientation, &Crack::orientation, false);
    visit(schema::crack_length, &Crack::length, false);
    visit(schema::crack_opening, &Crack::opening, false);
    visit(schema::crack_sliding, &Crack::sliding, false);
    visit(schema::crack_energy, &Crack::energy_released, false);
    const auto visit_moment = [&](CrackMoment Crack::*moment, const schema::Dataset& time, const schema::Dataset& opening,
                                  const schema::Dataset& sliding) {
        const auto part = [moment](double CrackMoment::*value) {
            return [ moment, value ](auto& crack) -> auto& { return crack.*moment.*value; };
        };
        visit(time, part(&CrackMoment::time), true);
        visit(opening, part(&CrackMoment::opening), true);
        visit(sliding, part(&CrackMoment::sliding), true);
    };
    using namespace schema;
    visit_moment(&Crack::damaged_10, crack_time_damaged_10, crack_opening_damaged_10, crack_sliding_damaged_10);
    visit_moment(&Crack::damaged_50, crack_time_damaged_50, crack_opening_damaged_50, crack_sliding_damaged_50);
    visit_moment(&Crack::broken, crack_time_broken, crack_opening_broken, crack_sliding_broken);
    visit_moment(&Crack::separated, crack_time_separated, crack_opening_separated, crack_sliding_separated);
}

/// Element type of the column of a member; a mode is stored as its number.
template <class Member>
using Element = std::conditional_t<std::is_same_v<std::decay_t<std::invoke_result_t<Member, Crack&>>, CrackMode>, std::uint8_t,
                                   std::decay_t<std::invoke_result_t<Member, Crack&>>>;

/// Requires entries from 0 to below a limit. \throws InputError for another
template <class T>
void require_below(const H5Input& file, const schema::Dataset& dataset, const std::vector<T>& values, std::size_t limit) {
    require_all(file, dataset.path, values, fmt::format("0 to {}", static_cast<double>(limit) - 1).c_str(),
                [limit](T value) { return value >= 0 && static_cast<std::size_t>(value) < limit; });
}

CrackMoment moment_of(const Crack& crack, CrackEvent event) {
    switch (event) {
        case CrackEvent::failed: return {crack.time, crack.opening, crack.sliding};
        case CrackEvent::half_damaged: return crack.damaged_50;
        default: return crack.broken;
    }
}

}  // namespace

std::optional<CrackMode> mode_of(const Crack& crack, const CrackLabel& label) {
    const CrackMoment moment = moment_of(crack, label.event);
    if (std::isnan(moment.time)) return std::nullopt;
    const bool tensile =
        label.mode == CrackModeRule::sign ? moment.opening >= 0 : crack.opening >= 0 && crack.mode_angle < std::numbers::pi / 4;
    return tensile ? CrackMode::tensile : CrackMode::shear;
}

std::vector<Crack> labelled(const std::vector<Crack>& log, const CrackLabel& label) {
    std::vector<Crack> found;
    for (Crack crack : log) {
        const std::optional<CrackMode> mode = mode_of(crack, label);
        if (!mode) continue;
        const CrackMoment moment = moment_of(crack, label.event);
        crack.mode = *mode;
        crack.time = moment.time;
        crack.opening = moment.opening;
        crack.sliding = moment.sliding;
        found.push_back(crack);
    }
    return found;
}

ModeCounts count_modes(const std::vector<Crack>& log, const CrackLabel& label, double time) {
    ModeCounts counts;
    for (const Crack& crack : labelled(log, label)) {
        if (crack.time <= time) counts.add(crack);
    }
    return counts;
}

void visit_crack_datasets(const VisitDataset& visit) {
    visit_columns([&](const schema::Dataset& dataset, const auto&... /*member*/) { visit(dataset); });
}

void write_cracks(H5Output& file, const std::vector<Crack>& cracks) {
    file.create_group(schema::cracks_group);
    visit_columns([&]<class Member>(const schema::Dataset& dataset, const Member& member, bool /*may_be_nan*/) {
        std::vector<Element<Member>> values;
        for (const Crack& crack : cracks) values.push_back(static_cast<Element<Member>>(std::invoke(member, crack)));
        write_rows(file, dataset, values);
    });
    file.attribute(schema::crack_mode.path, "names", std::vector<std::string>{"tensile", "shear"});
}

std::vector<Crack> read_cracks(const H5Input& file) {
    const std::size_t n = rows_of(file, schema::crack_time.path);
    const std::size_t n_contacts = rows_of(file, schema::contact_nodes.path);
    if (n > 2 * n_contacts) {
        throw InputError(fmt::format("{}: /cracks has {} rows, more than two for each of {} contacts: the file is damaged",
                                     file.name(), n, n_contacts));
    }
    std::vector<Crack> cracks(n);
    visit_columns([&]<class Member>(const schema::Dataset& dataset, const Member& member, bool may_be_nan) {
        using Number = typename Stored<Element<Member>>::Number;
        const std::vector<Number> numbers = file.read<Number>(dataset.path, extents_of<Element<Member>>(n));
        if constexpr (std::is_same_v<Number, double>) {
            require_all(file, dataset.path, numbers, may_be_nan ? "a finite number or NaN" : "a finite number",
                        [may_be_nan](double v) { return may_be_nan ? !std::isinf(v) : std::isfinite(v); });
        } else if constexpr (!std::is_same_v<Number, std::int64_t>) {
            require_below(file, dataset, numbers, std::is_same_v<Number, std::int32_t> ? n_contacts : 2);
        }
        const auto values = rows_from<Element<Member>>(numbers);
        for (std::size_t i = 0; i < n; ++i) {
            auto& to = std::invoke(member, cracks[i]);
            to = static_cast<std::decay_t<decltype(to)>>(values[i]);
        }
    });
    return cracks;
}

}  // namespace graincrack
