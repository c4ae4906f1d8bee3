#include "solver/restart/checkpoint.hpp"

#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <utility>
#include <vector>

#include "share/base/error.hpp"
#include "share/file/output_file.hpp"

namespace graincrack {
namespace {

volatile std::sig_atomic_t is_requested = 0;

/// Options of a test as its header tells them, as words. Numbers with all their digits.
std::vector<std::pair<std::string, std::string>> options_of(const RunHeader& h) {
    const auto number = [](double value) { return fmt::format("{}", value); };
    std::vector<std::pair<std::string, std::string>> options{{"the test", h.test},
                                                             {"--material", h.material},
                                                             {"--contact-law", h.contact_law},
                                                             {"--confining-pressure", number(h.confining_pressure)},
                                                             {"--heat", number(h.heat)},
                                                             {"--cool", h.cooled != 0 ? "given" : "left out"},
                                                             {"--platen-friction", number(h.platen_friction)},
                                                             {"--rate", h.rate},
                                                             {"--rate-tolerance", number(h.rate_tolerance)},
                                                             {"--rate-share", number(h.rate_share)},
                                                             {"the speed of the platens", number(h.platen_speed)},
                                                             {"--span", number(h.span)},
                                                             {"--damping", number(h.damping)},
                                                             {"--damping-form", h.damping_form},
                                                             {"the time step", number(h.time_step)}};
    for (const ContactParameter& row : all_contact_parameters()) options.emplace_back(row.option(), number(h.contact.*row.value));
    return options;
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
    const auto old_options = options_of(before);
    const auto options = options_of(now);
    for (std::size_t i = 0; i < options.size(); ++i) {
        if (options[i].second != old_options[i].second) {
            throw InputError(fmt::format("{}: {} was {}, not {} (SI units); a test resumes only with the options it began with",
                                         name, options[i].first, old_options[i].second, options[i].second));
        }
    }
}

}  // namespace graincrack
