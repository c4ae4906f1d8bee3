#include "solver/recorded_rate.hpp"

#include <algorithm>

#include "share/error.hpp"

namespace graincrack {

double RecordedRate::at(double strain_now) const {
    const auto next = std::upper_bound(strain.begin(), strain.end(), strain_now);
    return share * speed[static_cast<std::size_t>(std::min(next, strain.end() - 1) - strain.begin())];
}

RecordedRate recorded_rate(const std::string& name, const RunHeader& header, const History& history, double share) {
    const double sense = header.test == "tension" ? 1 : -1;
    const std::vector<double>& time = history[HistoryColumn::time];
    const std::vector<double>& strain = history[HistoryColumn::axial_strain];
    const std::vector<double>& speed = history[HistoryColumn::platen_speed];
    RecordedRate rate{{}, {}, share};
    const auto begin = static_cast<std::size_t>(
        std::lower_bound(time.begin(), time.end(), header.isotropic_end_time) - time.begin());
    for (std::size_t i = begin + 1; i < history.size(); ++i) {
        const double travelled = sense * (strain[i] - strain[begin]);
        if (travelled > (rate.strain.empty() ? 0 : rate.strain.back()) && speed[i] * -sense > 0) {
            rate.strain.push_back(travelled);
            rate.speed.push_back(speed[i] * -sense);
        }
    }
    if (rate.strain.empty()) {
        throw InputError(name + ": its platens do not move; a run of this test with a rate to repeat fits");
    }
    return rate;
}

}  // namespace graincrack
