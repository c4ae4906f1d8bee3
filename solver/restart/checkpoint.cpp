#include "solver/restart/checkpoint.hpp"

#include <fmt/format.h>

#include <csignal>
#include <filesystem>

#include "share/base/error.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {
namespace {

volatile std::sig_atomic_t is_requested = 0;

/// What decides the course of a test but for where it ends.
Settings course_of(const RunHeader& h) {
    Settings course{
        {"test", h.test}, {"material", h.material}, {"contact_law", h.contact_law}, {"plane", std::string(name_of(h.plane))}};
    for (const Setting& each : h.request) {
        if (each.group != SettingGroup::none && each.group != SettingGroup::end) course.push_back(each);
    }
    const Settings values = material_values(h);
    course.insert(course.end(), values.begin(), values.end());
    course.push_back({"time_step", h.time_step, Dimension::time});
    return course;
}

}  // namespace

void clear_checkpoint_name(const std::string& checkpoint, const std::string& restart, bool discard) {
    namespace fs = std::filesystem;
    if (!fs::exists(checkpoint) || (!restart.empty() && fs::equivalent(restart, checkpoint))) return;
    if (!discard) {
        throw UsageError(fmt::format(
            "{}: is the checkpoint of a run that has not ended; --restart {} resumes it, --discard-checkpoint starts again",
            checkpoint, checkpoint));
    }
    remove_checkpoint(checkpoint);
}

void remove_checkpoint(const std::string& checkpoint) {
    remove_file(checkpoint);
    remove_file(checkpoint + ".part");  // of a run that was killed as it wrote
}

void catch_checkpoint_signal() {
    std::signal(SIGUSR1, [](int /*signal*/) { is_requested = 1; });
}

bool take_checkpoint_request() noexcept {
    const bool requested = is_requested != 0;
    is_requested = 0;
    return requested;
}

bool is_checkpoint(const RunReader& run) { return run.header().stop_reason == "checkpoint"; }

void require_same_test(const std::string& name, const RunHeader& before, const RunHeader& now) {
    if (before.stop_reason != "checkpoint") {
        throw InputError(name + ": is a complete run, not a checkpoint; a test resumes from RUN.checkpoint");
    }
    constexpr int digits = 10;
    const Settings old_course = course_of(before), course = course_of(now);
    const auto [old_one, new_one] = first_difference(old_course, course, {});
    if (old_one == nullptr && new_one == nullptr) return;
    const auto value_of = [](const Setting* setting) { return setting == nullptr ? "not given" : shown(*setting, digits); };
    throw InputError(fmt::format("{}: --{} was {}, not {}; a test resumes only with the options it began with", name,
                                 option_name(old_one == nullptr ? *new_one : *old_one), value_of(old_one), value_of(new_one)));
}

}  // namespace graincrack
