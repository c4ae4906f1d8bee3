// Messages of a program at work: lines on stderr, and events for other programs (--events). Events are JSON objects, one per
// line, in the form of share/doc/file-format.md.
#pragma once

#include <ostream>
#include <string>
#include <utility>

namespace graincrack {

/// Amount of messages on stderr.
enum class Verbosity { quiet, normal, verbose };

/// The stream of lines for the user: stderr, or a stream without output with --quiet.
std::ostream& diagnostics(Verbosity verbosity);

/// A note or warning about an input or a result.
struct Remark {
    Remark(std::string text_, std::string code_ = "") : text(std::move(text_)), code(std::move(code_)) {}
    std::string text;
    std::string code;  ///< fixed short word of a warning, such as "few_crystals"; "" for a note
};

/// Opens the target of events. \param target number of an open descriptor, or a file, which is replaced
/// \throws UsageError for a descriptor that is not open for writing; OutputError for a file that cannot be written
void open_events(const std::string& target);
/// Leaves events to another process, the first of several ranks: later calls of `open_events` have no effect.
void leave_events();

/// Writes a line and an event with it. Lines that cannot be written to stderr (full disk) are lost and do not end the work. The
/// same holds for events, unless their reader has closed the pipe: then the work stops as by SIGHUP.
void say(std::ostream& out, const std::string& line);
/// Writes the line "SUBJECT: warning: TEXT" and an event with its code. \param file the file that the warning is about
void warn(std::ostream& out, const std::string& subject, const Remark& warning, const std::string& file = "");
/// Writes an event of work in progress, for `Progress`. \param fraction completed fraction of the work, 0 to 1
void tell_progress(const std::string& label, double fraction, const std::string& text);

/// Adds a value in SI units, or a text, to the last event.
void add_to_outcome(const std::string& name, double value);
void add_to_outcome(const std::string& name, const std::string& value);
/// Adds an existing file or folder to the last event.
void add_output_to_outcome(const std::string& path);
/// Writes the last event. \param error the error message of the program on stderr; "" without an error
void end_events(int exit_code, const std::string& error);

}  // namespace graincrack
