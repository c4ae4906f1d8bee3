#include "solver/run/frame_output.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/model/gather.hpp"

namespace graincrack {
namespace {

/// Motions, tractions, damage and states of all contact points, into a frame.
template <class Law>
void add_contacts(const Assemblage& a, const ContactLaws& laws, const State& s, Frame& frame) {
    for (auto* pairs : {&frame.opening, &frame.sliding, &frame.damage}) pairs->resize(a.n_contacts());
    frame.traction.resize(a.n_contacts());
    frame.state.resize(a.n_contacts());
    for_each_own_contact(a, [&](std::int32_t place, std::int32_t contact_class) {
        const ContactLaw& law = laws[contact_class];
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
    });
}

}  // namespace

Frame make_frame(const Assemblage& a, const ContactLaws& laws, const State& s) {
    Frame frame;
    frame.time = s.time;
    frame.step = s.step;
    frame.displacement.resize(a.node_of_specimen.size());
    frame.velocity.resize(a.node_of_specimen.size());
    frame.element_stress.resize(a.element_nodes.size());
    for (std::size_t k = 0; k < a.node_of_specimen.size(); ++k) {
        const std::int32_t i = a.node_of_specimen[k];
        if (!a.part.owns(i)) continue;
        frame.displacement[k] = {s.displacement[i].x, s.displacement[i].y};
        frame.velocity[k] = {s.velocity[i].x, s.velocity[i].y};
    }
    for (const std::int32_t chunk : a.part.elements.own) {
        const Range elements = a.element_chunks[chunk];
        for (std::int32_t e = elements.begin; e < elements.end; ++e) {
            frame.element_stress[e] = triangle_stress(a.elasticity[e], element_state(a, static_cast<std::size_t>(e), s));
        }
    }
    contact_law::with_law(laws.variant(), [&](auto kind) { add_contacts<decltype(kind)>(a, laws, s, frame); });
    return frame;
}

Frame whole_frame(const Assemblage& a, Frame own) {
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

FrameOutput::FrameOutput(int requested, double first_interval, RunWriter* writer)
    : requested_(requested), interval_(first_interval), writer_(writer) {}

void FrameOutput::resume(const FrameProgress& progress, const RunReader& checkpoint) {
    if (requested_ == 0) return;
    next_ = progress.next;
    interval_ = progress.interval;
    regular_ = progress.regular;
    for (std::size_t i = 0; i < progress.roles.size(); ++i) {
        if (progress.roles[i] == FrameRole::peak_so_far) {
            peak_ = checkpoint.frame(i);
        } else if (progress.roles[i] != FrameRole::present && writer_ != nullptr) {
            writer_->add_frame(checkpoint.frame(i), progress.roles[i]);
        }
    }
    thin_if_too_many();
}

FrameProgress FrameOutput::save(const Assemblage& a, const ContactLaws& laws, const State& state, RunWriter* checkpoint) const {
    const std::optional<Frame> peak = peak_ ? std::optional(whole_frame(a, *peak_)) : std::nullopt;
    const Frame present = whole_frame(a, make_frame(a, laws, state));
    if (checkpoint == nullptr) return {};
    checkpoint->add_frames(*writer_);
    if (peak) checkpoint->add_frame(*peak, FrameRole::peak_so_far);
    checkpoint->add_frame(present, FrameRole::present);
    return {next_, interval_, regular_, checkpoint->frame_roles()};
}

void FrameOutput::add(const Assemblage& a, Frame own, FrameRole role) {
    const Frame frame = whole_frame(a, std::move(own));
    if (writer_ != nullptr) writer_->add_frame(frame, role);
}

void FrameOutput::thin_if_too_many() {
    while (regular_ >= 2 * requested_) {
        if (writer_ != nullptr) writer_->thin_frames();
        regular_ = (regular_ + 1) / 2;
        interval_ *= 2;
    }
}

bool FrameOutput::regular(double strain, const Assemblage& a, const ContactLaws& laws, const State& state) {
    if (requested_ == 0 || strain < next_) return false;
    add(a, make_frame(a, laws, state), FrameRole::regular);
    ++regular_;
    thin_if_too_many();
    next_ = interval_ * (std::floor(strain / interval_) + 1);
    return true;
}

bool FrameOutput::peak(bool is_highest, bool has_fallen, const Assemblage& a, const ContactLaws& laws, const State& state) {
    if (requested_ == 0) return false;
    if (is_highest) {
        peak_ = make_frame(a, laws, state);
        return false;
    }
    const bool is_final = has_fallen && peak_;
    if (is_final) {
        add(a, *peak_, FrameRole::kept);
        peak_.reset();
    }
    return is_final;
}

void FrameOutput::last(const Assemblage& a, const ContactLaws& laws, const State& state) {
    if (peak_ && peak_->step < state.step) add(a, *peak_, FrameRole::kept);
    add(a, make_frame(a, laws, state), FrameRole::kept);
}

}  // namespace graincrack
