#include "solver/setup/program.hpp"

#include <algorithm>

namespace graincrack {
namespace {

bool waves(const Settings& settings) {
    return std::any_of(settings.begin(), settings.end(), [](const auto& f) { return f && f->is_wave(); });
}

}  // namespace

const Stage& Program::stage(const std::string& stage_name) const {
    return *std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.name == stage_name; });
}

double Program::longest_time() const {
    double sum = 0;
    for (const std::string& stage_name : order) {
        sum += stage(stage_name).longest_time;
    }
    return sum;
}

std::string Program::why_dynamic() const {
    if (!initial_velocities.empty()) {
        return "it starts in motion";
    }
    for (const Control& control : controls) {
        if (control.is_set[0] || control.is_set[1]) {
            return "boundary." + control.name + " drives nodes";
        }
        if (waves(control.start)) {
            return "boundary." + control.name + " makes waves";
        }
        for (const Stage& s : stages) {
            const auto found = s.settings.find(control.name);
            if (found != s.settings.end() && waves(found->second)) {
                return "stage." + s.name + "." + control.name + " makes waves";
            }
        }
    }
    return "";
}

const std::vector<ProbeColumn>& control_columns() {
    static const std::vector<ProbeColumn> columns{
        {"displacement_x", Dimension::length, "mean displacement along x of its nodes"},
        {"displacement_y", Dimension::length, "mean displacement along y of its nodes"},
        {"force_x", Dimension::force, "force on the specimen along x per metre of thickness, reaction without inertia and loads"},
        {"force_y", Dimension::force, "force on the specimen along y per metre of thickness, reaction without inertia and loads"},
    };
    return columns;
}

const std::vector<ProbeColumn>& point_columns() {
    static const std::vector<ProbeColumn> columns{
        {"displacement_x", Dimension::length, "displacement along x"},
        {"displacement_y", Dimension::length, "displacement along y"},
        {"velocity_x", Dimension::speed, "velocity along x, half a step before"},
        {"velocity_y", Dimension::speed, "velocity along y, half a step before"},
    };
    return columns;
}

const std::vector<ProbeColumn>& circle_columns() {
    static const std::vector<ProbeColumn> columns{
        {"stress_xx", Dimension::stress, "mean stress xx of the elements with their centre in the circle, tension positive"},
        {"stress_yy", Dimension::stress, "mean stress yy of the elements with their centre in the circle, tension positive"},
        {"stress_xy", Dimension::stress, "mean stress xy of the elements with their centre in the circle"},
        {"stress_zz", Dimension::stress, "mean stress zz of the elements with their centre in the circle, tension positive"},
    };
    return columns;
}

}  // namespace graincrack
