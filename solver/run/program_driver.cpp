#include "solver/run/program_driver.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "share/error.hpp"
#include "share/h5_file.hpp"
#include "share/schema.hpp"

namespace graincrack {
namespace {

constexpr double history_rows = 8000;  // of the longest time: as of a test
constexpr std::int64_t min_steps = 10;

template <class T>
std::vector<double> column_of(const std::vector<StageRecord>& records, T StageRecord::*member) {
    std::vector<double> column;
    std::transform(records.begin(), records.end(), std::back_inserter(column), [&](const StageRecord& r) { return r.*member; });
    return column;
}
std::vector<std::string> words_of(const std::vector<StageRecord>& records, std::string StageRecord::*member) {
    std::vector<std::string> words;
    std::transform(records.begin(), records.end(), std::back_inserter(words), [&](const StageRecord& r) { return r.*member; });
    return words;
}

/// What a program began with that went on from another run.
void write_start(H5Output& file, const StageControllerState& start) {
    const std::string group = schema::program_group;
    file.attribute(group, "start_controls", start.names);
    file.attribute(group, "start_control_values", start.values);
    file.attribute(group, "start_platen_speed", start.platen_speed);
    file.attribute(group, "start_mean_compression", start.mean_compression);
}

std::optional<StageControllerState> read_start(const H5Input& file) {
    const std::string group = schema::program_group;
    const double speed = file.attribute_or<double>(group, "start_platen_speed", NAN);
    if (std::isnan(speed)) {
        return std::nullopt;
    }
    return StageControllerState{file.attribute<std::vector<std::string>>(group, "start_controls"),
                                file.attribute<std::vector<double>>(group, "start_control_values"), speed,
                                file.attribute<double>(group, "start_mean_compression")};
}

}  // namespace

std::int64_t program_interval_steps(const Program& program, double time_step) {
    const double interval = program.row_interval.value_or(program.longest_time() / history_rows);
    return std::max<std::int64_t>(program.row_interval ? 1 : min_steps, std::llround(interval / time_step));
}

ProgramDriver::ProgramDriver(const Program& program, const Assemblage& assemblage, const Specimen& specimen, const Rock& rock)
    : program_(program), stage_controller_(program, specimen, rock), probes_(program, assemblage, specimen) {}

template <class Act>
void ProgramDriver::with_feedback(const RunView& view, Act&& act) {
    const std::function<double(const std::string&, std::size_t)> probe = [this](const std::string& name, std::size_t column) {
        return probes_.last(name, column);
    };
    act(StageFeedback{view.state.time, view.history, probe});
}

std::int64_t ProgramDriver::interval_steps(double time_step) const { return program_interval_steps(program_, time_step); }

IntervalLoading ProgramDriver::next(const RunView& view, double duration) {
    IntervalLoading batch;
    with_feedback(view, [&](const StageFeedback& feedback) { batch = stage_controller_.next(feedback, duration); });
    return batch;
}

void ProgramDriver::note(const RunView& view) {
    probes_.record(view.assemblage, view.boundary, view.state);
    with_feedback(view, [&](const StageFeedback& feedback) {
        begun_ ? stage_controller_.check_stage_end(feedback) : stage_controller_.begin(feedback);
    });
    begin_ = begun_ ? begin_ : view.state.time;
    begun_ = true;
}

void ProgramDriver::resume(const StageControllerState& state) {
    stage_controller_.resume(state);
    started_from_ = state;
}

void ProgramDriver::go_on(const StageControllerState& /*state*/, const RunReader& checkpoint, double time_step) {
    const H5Input& file = checkpoint.file();
    if (file.attribute_or<std::string>(schema::program_group, "text", "") != program_.text) {
        throw InputError(checkpoint.name() + ": is the checkpoint of another program than " + program_.file +
                         "; it goes on with its own");
    }
    if (const auto start = read_start(file)) {
        resume(*start);
    }
    probes_.restore(file);
    const History rows = checkpoint.history();
    const double duration = static_cast<double>(interval_steps(time_step)) * time_step;
    History so_far;
    std::size_t row = 0;
    const std::function<double(const std::string&, std::size_t)> probe = [&](const std::string& name, std::size_t column) {
        return probes_.value(name, column, row);
    };
    for (; row < rows.size(); ++row) {
        for (std::size_t c = 0; c < so_far.columns.size(); ++c) {
            so_far.columns[c].push_back(rows.columns[c][row]);
        }
        const StageFeedback feedback{rows[HistoryColumn::time][row], so_far, probe};
        row == 0 ? stage_controller_.begin(feedback) : stage_controller_.check_stage_end(feedback);
        if (row + 1 < rows.size()) {
            stage_controller_.next(feedback, duration);
        }
    }
    begun_ = true;
    begin_ = rows[HistoryColumn::time].front();
}

std::string ProgramDriver::stop_reason(const RunView& view) const {
    if (stage_controller_.finished()) {
        return "end of the program";
    }
    return program_.platens && std::abs(view.axial_strain) >= program_.platens->max_strain ? "strain cap" : "";
}

double ProgramDriver::progress(const RunView& view) const { return (view.state.time - begin_) / program_.longest_time(); }

void ProgramDriver::complete(RunHeader& header, double time) {
    header.platen_speed = stage_controller_.platen_speed();
    stage_controller_.close(time, header.stop_reason);
}

void ProgramDriver::append(H5Output& file, std::size_t first) const { append_probes(file, probes_.histories(), first); }

void ProgramDriver::write(H5Output& file) const {
    const std::string group = schema::program_group;
    const std::vector<StageRecord>& records = stage_controller_.records();
    file.create_group(group);
    file.attribute(group, "name", program_.name);
    file.attribute(group, "text", program_.text);
    if (started_from_) {
        write_start(file, *started_from_);
    }
    file.attribute(group, "stages", words_of(records, &StageRecord::name));
    file.attribute(group, "ended_by", words_of(records, &StageRecord::ended_by));
    const auto times = [&](const char* name, double StageRecord::*member, std::string_view description) {
        const std::vector<double> values = column_of(records, member);
        file.write<double>(group + "/" + name, std::span<const double>(values), {values.size()}, "s", description);
    };
    times("begin", &StageRecord::begin, "time at which a stage began, in the order of the attribute stages");
    times("end", &StageRecord::end, "time at which it ended");
}

}  // namespace graincrack
