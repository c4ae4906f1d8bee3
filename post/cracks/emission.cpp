#include "post/cracks/emission.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "post/table/column.hpp"
#include "share/base/union_find.hpp"
#include "share/rock/fracture_process_zone.hpp"

namespace graincrack {

namespace {

double jump(const Crack& crack) { return std::hypot(crack.opening, crack.sliding); }

EmissionEvent event_of(const std::vector<Crack>& cracks, const std::vector<std::size_t>& members, double shear_modulus) {
    EmissionEvent event;
    event.time = cracks[members.front()].time;
    event.duration = cracks[members.back()].time - event.time;
    const auto n = static_cast<double>(members.size());
    event.contacts = n / 2;
    for (const std::size_t i : members) {
        const Crack& crack = cracks[i];
        for (std::size_t axis = 0; axis < 2; ++axis) event.position[axis] += crack.position[axis] / n;
        if (crack.mode == CrackMode::tensile) event.tensile_share += 1 / n;
        event.length += crack.length;
        event.energy += crack.energy_released;
        event.moment += shear_modulus * crack.length * jump(crack);
    }
    return event;
}

}  // namespace

EmissionWindow default_window(const Rock& rock, double mean_edge) {
    const double shear_speed = std::sqrt(fpz::shear_modulus(rock) / rock.density);
    const double distance = 2 * mean_edge;
    return {distance, distance / (0.5 * shear_speed)};
}

double EmissionEvent::magnitude() const { return 2.0 / 3 * std::log10(moment) - 6.07; }

std::vector<EmissionEvent> find_events(std::vector<Crack> cracks, const Rock& rock, const EmissionWindow& window) {
    std::stable_sort(cracks.begin(), cracks.end(), [](const Crack& a, const Crack& b) { return a.time < b.time; });
    UnionFind sets(cracks.size());
    for (std::size_t i = 0; i < cracks.size(); ++i) {
        for (std::size_t j = i + 1; j < cracks.size() && cracks[j].time - cracks[i].time <= window.time; ++j) {
            const double distance =
                std::hypot(cracks[j].position[0] - cracks[i].position[0], cracks[j].position[1] - cracks[i].position[1]);
            if (distance <= window.distance) sets.join(i, j);
        }
    }
    std::map<std::size_t, std::vector<std::size_t>> members;  // by the first point
    for (std::size_t i = 0; i < cracks.size(); ++i) members[sets.find(i)].push_back(i);
    std::vector<EmissionEvent> events;
    for (const auto& [first, points] : members) events.push_back(event_of(cracks, points, fpz::shear_modulus(rock)));
    return events;
}

std::vector<double> magnitudes_of(const std::vector<EmissionEvent>& events) {
    std::vector<double> magnitudes;
    for (const EmissionEvent& event : events) {
        if (event.moment > 0) magnitudes.push_back(event.magnitude());
    }
    return magnitudes;
}

double completeness_of(const std::vector<double>& magnitudes) {
    constexpr double bin = 0.1;
    std::map<long, std::size_t> counts;
    for (const double m : magnitudes) ++counts[std::lround(m / bin)];
    const auto most =
        std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return static_cast<double>(most->first) * bin - bin / 2;
}

namespace {

/// Largest distance between two distributions (Kolmogorov–Smirnov): of magnitudes from `low` on, and exponential.
double distance_to_exponential(std::vector<double> magnitudes, double low, double mean) {
    std::erase_if(magnitudes, [low](double m) { return m < low; });
    std::sort(magnitudes.begin(), magnitudes.end());
    const double n = static_cast<double>(magnitudes.size());
    double distance = 0;
    for (std::size_t i = 0; i < magnitudes.size(); ++i) {
        const double expected = 1 - std::exp(-(magnitudes[i] - low) / mean);
        distance = std::max({distance, expected - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - expected});
    }
    return distance;
}

}  // namespace

std::optional<GutenbergRichter> fit_gutenberg_richter(const std::vector<double>& magnitudes, double completeness) {
    double sum = 0;
    std::size_t n = 0;
    for (const double m : magnitudes) {
        if (m < completeness) continue;
        sum += m;
        ++n;
    }
    constexpr std::size_t fewest = 10;
    if (n < fewest) return std::nullopt;
    const double above = sum / static_cast<double>(n) - completeness;
    if (!(above > 0)) return std::nullopt;
    const double b = std::log10(std::numbers::e) / above;
    return GutenbergRichter{b, b / std::sqrt(static_cast<double>(n)), completeness, n,
                            distance_to_exponential(magnitudes, completeness, above)};
}

double GutenbergRichter::distance_by_chance() const {
    const double n = static_cast<double>(events);
    return 1.094 / (std::sqrt(n) + 0.26 + 0.5 / std::sqrt(n)) + 0.2 / n;
}

void write_events(std::ostream& out, const std::vector<EmissionEvent>& events, TableFormat format) {
    using namespace unit;
    using Event = EmissionEvent;
    const Event* const first = events.data();
    const Columns<Event> columns{{"event", none, [first](const Event& e) { return &e - first; }},
                                 {"time", second, [](const Event& e) { return e.time; }},
                                 {"duration", second, [](const Event& e) { return e.duration; }},
                                 {"x", millimetre, [](const Event& e) { return e.position[0]; }},
                                 {"y", millimetre, [](const Event& e) { return e.position[1]; }},
                                 {"contacts", none, [](const Event& e) { return count_cell(e.contacts); }},
                                 {"tensile_share", none, [](const Event& e) { return e.tensile_share; }},
                                 {"length", millimetre, [](const Event& e) { return e.length; }},
                                 {"energy", joule, [](const Event& e) { return e.energy; }},
                                 {"moment", newton_metre, [](const Event& e) { return e.moment; }},
                                 {"magnitude", none, [](const Event& e) { return e.magnitude(); }}};
    write_table(out, columns, events, format);
}

}  // namespace graincrack
