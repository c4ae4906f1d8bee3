#include "solver/run/frame_output.hpp"

#include <cmath>

#include "solver/model/gather.hpp"

namespace graincrack {
namespace {

/// Motions, tractions, damage and states of the points of a chunk of contacts, into a frame.
template <class Law>
void find_contacts(const Assemblage& a, const ContactLaws& laws, std::int32_t index, const State& s, Frame& frame) {
    const ContactChunk& chunk = a.contact_chunks[index];
    const ContactLaw& law = laws[chunk.contact_class];
    for (std::int32_t place = chunk.contacts.begin; place < chunk.contacts.end; ++place) {
        const std::int32_t c = a.specimen_contact[place];
        const double strength = a.contacts[place].strength;
        const bool released = s.contact_pairs.released[place] != 0;  // node–edge contacts carry its load
        for (std::size_t end = 0; end < 2; ++end) {
            const ContactHistory h = point_history(s, points_of(place)[end]);
            const ContactTraction t = released ? ContactTraction{} : contact_law::update<Law>(law, h.motion, h).traction;
            frame.opening[c][end] = strength * h.motion.opening;
            frame.sliding[c][end] = strength * h.motion.sliding;
            frame.traction[c][2 * end] = strength * t.normal;
            frame.traction[c][2 * end + 1] = strength * t.shear;
            frame.damage[c][end] = contact_law::damage<Law>(law, h);
            frame.state[c][end] = static_cast<std::uint8_t>(point_state(h));
        }
    }
}

}  // namespace

Frame make_frame(const Assemblage& a, const ContactLaws& laws, const State& s, ThreadTeam& team, Frame frame) {
    frame.time = s.time;
    frame.step = s.step;
    for (auto* of_nodes : {&frame.displacement, &frame.velocity}) of_nodes->resize(a.node_of_specimen.size());
    frame.element_stress.resize(a.element_nodes.size());
    for (auto* pairs : {&frame.opening, &frame.sliding, &frame.damage}) pairs->resize(a.n_contacts());
    frame.traction.resize(a.n_contacts());
    frame.state.resize(a.n_contacts());
    for_each_of_team(team, a.node_of_specimen.size(), [&](std::size_t k) {
        const std::int32_t i = a.node_of_specimen[k];
        if (!a.part.owns(i)) return;
        frame.displacement[k] = {s.displacement[i].x, s.displacement[i].y};
        frame.velocity[k] = {s.velocity[i].x, s.velocity[i].y};
    });
    for_each_of_team(team, a.part.elements.own.size(), [&](std::size_t i) {
        const Range elements = a.element_chunks[a.part.elements.own[i]];
        for (std::int32_t e = elements.begin; e < elements.end; ++e) {
            frame.element_stress[e] = element_stress(a, static_cast<std::size_t>(e), s);
        }
    });
    contact_law::with_law(laws.variant(), [&](auto kind) {
        for_each_of_team(team, a.part.contacts.own.size(),
                         [&](std::size_t i) { find_contacts<decltype(kind)>(a, laws, a.part.contacts.own[i], s, frame); });
    });
    return frame;
}

Frame FrameOutput::whole(Frame own) const {
    const Assemblage& a = setup_.assemblage;
    const Part& part = a.part;
    const auto owner_of_node = [&](std::int32_t k) { return part.owner_of_node(a.node_of_specimen[k]); };
    const auto owner_of_contact = [&](std::int32_t c) {
        return part.contacts.owner_of(a.contact_of_specimen[c] / contacts_per_chunk);
    };
    for (auto* of_nodes : {&own.displacement, &own.velocity}) gather_items(part, owner_of_node, *of_nodes);
    gather_chunks(part, part.elements, elements_per_chunk, own.element_stress);
    for (auto* of_contacts : {&own.opening, &own.sliding, &own.damage}) gather_items(part, owner_of_contact, *of_contacts);
    gather_items(part, owner_of_contact, own.traction);
    gather_items(part, owner_of_contact, own.state);
    return own;
}

void FrameOutput::resume(const FrameProgress& progress, const RunReader& checkpoint) {
    if (requested_ == 0) return;
    next_ = progress.next;
    interval_ = progress.interval;
    regular_ = progress.regular;
    for (std::size_t i = 0; i < progress.roles.size(); ++i) {
        if (progress.roles[i] == FrameRole::peak_so_far) {
            peak_ = checkpoint.frame(i);
        } else if (progress.roles[i] != FrameRole::present && file_ != nullptr) {
            file_->when_done().add_frame(checkpoint.frame(i), progress.roles[i]);
        }
    }
    while (regular_ >= 2 * requested_) thin();
}

std::function<FrameProgress(const RunWriter& run, RunWriter& checkpoint)> FrameOutput::save() const {
    return [next = next_, interval = interval_, regular = regular_, peak = peak_ ? std::optional(whole(*peak_)) : std::nullopt,
            present = whole(now())](const RunWriter& run, RunWriter& checkpoint) {
        checkpoint.add_frames(run);
        if (peak) checkpoint.add_frame(*peak, FrameRole::peak_so_far);
        checkpoint.add_frame(present, FrameRole::present);
        return FrameProgress{next, interval, regular, checkpoint.frame_roles()};
    };
}

void FrameOutput::add(Frame own, FrameRole role) {
    Frame frame = whole(std::move(own));
    if (file_ != nullptr) file_->later([frame = std::move(frame), role](RunWriter& run) { run.add_frame(frame, role); });
}

void FrameOutput::thin() {
    if (file_ != nullptr) file_->when_done().thin_frames();
    regular_ = (regular_ + 1) / 2;
    interval_ *= 2;
}

void FrameOutput::regular(double strain) {
    if (requested_ == 0 || strain < next_) return;
    if (regular_ + 1 < 2 * requested_) {
        add(now(), FrameRole::regular);
        ++regular_;
    } else {
        thin();  // every second one, also this
    }
    next_ = interval_ * (std::floor(strain / interval_) + 1);
}

void FrameOutput::peak(bool is_highest, bool has_fallen) {
    if (requested_ == 0) return;
    if (is_highest) {
        peak_ = now(peak_ ? std::move(*peak_) : Frame{});
    } else if (has_fallen && peak_) {
        add(*std::exchange(peak_, {}), FrameRole::kept);
    }
}

void FrameOutput::last() {
    if (peak_ && peak_->step < state_.step) add(*peak_, FrameRole::kept);
    add(now(), FrameRole::kept);
}

}  // namespace graincrack
