#include "solver/run/crack_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

namespace graincrack {
namespace {

Crack make_crack(const ContactEvent& event, double length, double time) {
    Crack crack;
    crack.time = time;
    crack.step = event.step;
    crack.contact = event.contact;
    crack.point = event.point;
    crack.mode = event.mode;
    crack.mode_angle = std::atan2(std::abs(event.peak_traction.shear), event.peak_traction.normal);
    crack.position = {event.position.x, event.position.y};
    const double angle = std::atan2(event.tangent.y, event.tangent.x);
    crack.orientation = angle < 0 ? angle + std::numbers::pi : (angle >= std::numbers::pi ? angle - std::numbers::pi : angle);
    crack.length = length;
    crack.opening = event.motion.opening;
    crack.sliding = event.motion.sliding;
    return crack;
}

/// An event of a point after its failure, or in the same step.
void record_later_event(const ContactEvent& event, double time, Crack& crack) {
    const CrackMoment now{time, event.motion.opening, event.motion.sliding};
    switch (event.kind) {
        case ContactEventKind::failure: break;
        case ContactEventKind::damaged_10: crack.damaged_10 = now; break;
        case ContactEventKind::damaged_50: crack.damaged_50 = now; break;
        case ContactEventKind::broken: crack.broken = now; break;
        case ContactEventKind::separation: crack.separated = now; break;
    }
}

}  // namespace

void CrackLog::collect(const Assemblage& a, double time_step, State& state) {
    std::vector<ContactEvent> own;
    for (const std::int32_t chunk : a.part.contacts.own) {
        for (ContactEvent& event : state.events[chunk]) {
            event.contact = a.specimen_contact[event.contact];
            own.push_back(event);
        }
    }
    for_each_evaluated(a.part.evaluated_contacts, [&](std::int32_t chunk) { state.events[chunk].clear(); });
    std::vector<ContactEvent> events;
    for (const std::vector<ContactEvent>& of_rank : a.part.ranks->gather_first(own)) {
        events.insert(events.end(), of_rank.begin(), of_rank.end());
    }
    std::sort(events.begin(), events.end(), [](const ContactEvent& l, const ContactEvent& r) {
        return std::tie(l.step, l.contact, l.point, l.kind) < std::tie(r.step, r.contact, r.point, r.kind);
    });
    for (const ContactEvent& event : events) {
        const std::size_t point = 2 * static_cast<std::size_t>(event.contact) + event.point;
        const double time = time_of(state, event.step, time_step);
        if (event.kind != ContactEventKind::failure) {
            if (crack_of_point_[point] >= 0) record_later_event(event, time, cracks_[crack_of_point_[point]]);
            continue;
        }
        crack_of_point_[point] = static_cast<std::int32_t>(cracks_.size());
        cracks_.push_back(make_crack(event, a.contacts[a.contact_of_specimen[event.contact]].point_area, time));
        tensile_ += event.mode == CrackMode::tensile ? 1 : 0;
    }
    const auto counts = a.part.ranks->of_first(std::array{cracks_.size(), tensile_});
    count_ = counts[0];
    tensile_ = counts[1];
}

void CrackLog::restore(const std::vector<Crack>& rows) {
    cracks_ = rows;
    count_ = rows.size();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        crack_of_point_[2 * static_cast<std::size_t>(rows[i].contact) + rows[i].point] = static_cast<std::int32_t>(i);
        tensile_ += rows[i].mode == CrackMode::tensile ? 1 : 0;
    }
}

std::vector<Crack> CrackLog::rows(const Assemblage& a, const State& state) const {
    std::vector<Crack> rows = cracks_;
    for (Crack& crack : rows) {
        crack.energy_released = state.fracture_energy[points_of(a.contact_of_specimen[crack.contact])[crack.point]];
    }
    return rows;
}

}  // namespace graincrack
