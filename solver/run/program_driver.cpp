#include "solver/run/program_driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"
#include "solver/program/standard_tests.hpp"

namespace graincrack {
namespace {

template <class T>
std::vector<T> column_of(const std::vector<StageRecord>& records, T StageRecord::*member) {
    std::vector<T> column;
    std::transform(records.begin(), records.end(), std::back_inserter(column), [&](const StageRecord& r) { return r.*member; });
    return column;
}

/// The start of a program that continued another run.
void write_start(H5Output& file, const StageControllerState& start) {
    const std::string group = schema::program_group;
    file.attribute(group, "start_amplitudes", start.boundary_conditions.names);
    file.attribute(group, "start_amplitude_values", start.boundary_conditions.values);
    file.attribute(group, "start_platen_speed", start.platen_speed);
    file.attribute(group, "start_mean_compression", start.mean_compression);
}

std::optional<StageControllerState> read_start(const H5Input& file) {
    const std::string group = schema::program_group;
    const double speed = file.attribute_or<double>(group, "start_platen_speed", NAN);
    if (std::isnan(speed)) return std::nullopt;
    StageControllerState start;
    start.boundary_conditions = {file.attribute<std::vector<std::string>>(group, "start_amplitudes"),
                                 file.attribute<std::vector<double>>(group, "start_amplitude_values")};
    start.platen_speed = speed;
    start.mean_compression = file.attribute<double>(group, "start_mean_compression");
    if (start.boundary_conditions.names.size() != start.boundary_conditions.values.size()) {
        throw InputError(file.name() + ": names and values of the start of its program differ in number");
    }
    return start;
}

}  // namespace

ProgramDriver::ProgramDriver(const Program& program, TestKind test, const Assemblage& assemblage, const Specimen& specimen,
                             const Rock& rock)
    : program_(program),
      test_(test),
      stages_(program, specimen, rock, expansion_difference(assemblage)),
      probes_(program, assemblage, specimen) {}

void ProgramDriver::record(const Assemblage& assemblage, const Boundary& boundary, const State& state, const History& history,
                           const Feedback& feedback) {
    probes_.record(assemblage, boundary, state);
    begun_ ? stages_.check_stage_end(feedback, rows_of(history)) : stages_.begin(feedback);
    begun_ = true;
}

void ProgramDriver::take_over(const StageControllerState& state) {
    stages_.take_over(state);
    started_from_ = state;
}

void ProgramDriver::resume(const StageControllerState& state, const RunReader& checkpoint) {
    const H5Input& file = checkpoint.file();
    if (!is_standard() && file.attribute_or<std::string>(schema::program_group, "text", "") != program_.text) {
        throw InputError(checkpoint.name() + ": is the checkpoint of another program than " + program_.file +
                         "; resume it with its own program");
    }
    if (!is_standard()) started_from_ = read_start(file);
    if (keeps_probes()) probes_.restore(file, checkpoint.history().size());
    try {
        stages_.resume(state);
    } catch (const InputError& error) {
        throw InputError(checkpoint.name() + ": " + error.what());
    }
    begun_ = true;
}

std::string ProgramDriver::stop_reason() const {
    if (!stages_.finished()) return stages_.is_at_strain_limit() ? "strain limit" : "";
    if (!is_standard()) return "end of the program";
    return stages_.records().back().ended_by == ended_by_peak_drop ? "peak drop" : "mouth opening";
}

void ProgramDriver::complete(RunHeader& header) {
    const std::vector<StageRecord>& records = stages_.records();
    const double time = stages_.feedback().time;
    if (!is_standard()) {
        header.platen_speed = stages_.platens().speed();
    } else if (header.rate == name_of(RateKind::automatic)) {
        header.platen_speed = stages_.platens().mean_speed(time);
    }
    if (is_standard() && !records.empty() && records.front().name != axial_stage) {
        const bool ends_axially = records.back().name == axial_stage;
        header.isotropic_end_time = ends_axially ? records.back().begin : records.back().end;
        if (header.stop_reason == "strain limit" && header.isotropic_end_time >= time) {
            throw UsageError(fmt::format(
                "--max-strain: {} is reached when the confining pressure is, before axial loading begins; a larger one "
                "or a lower --confining-pressure is needed",
                program_.platens->max_strain));
        }
    }
    stages_.close(header.stop_reason);
}

void ProgramDriver::append(H5Output& file, std::size_t first) const {
    if (keeps_probes()) append_probes(file, probes_.histories(), first);
}

void ProgramDriver::write(H5Output& file) const {
    if (is_standard()) return;
    const std::string group = schema::program_group;
    const std::vector<StageRecord>& records = stages_.records();
    file.create_group(group);
    file.attribute(group, "name", program_.name);
    file.attribute(group, "text", program_.text);
    if (started_from_) write_start(file, *started_from_);
    file.attribute(group, "stages", column_of(records, &StageRecord::name));
    file.attribute(group, "ended_by", column_of(records, &StageRecord::ended_by));
    const auto times = [&](const char* name, double StageRecord::*member, std::string_view description) {
        const std::vector<double> values = column_of(records, member);
        file.write<double>(group + "/" + name, std::span<const double>(values), {values.size()}, "s", description);
    };
    times("begin", &StageRecord::begin, "time at which a stage began, in the order of the attribute stages");
    times("end", &StageRecord::end, "time at which it ended");
}

}  // namespace graincrack
