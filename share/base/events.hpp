// What a program says while it works: lines on stderr, and events for other programs (--events), which are JSON
// objects, one a line, in the form of share/doc/file-format.md.
#pragma once

#include <ostream>
#include <string>
#include <utility>

namespace graincrack {

/// How much a tool says on stderr.
enum class Verbosity { quiet, normal, verbose };

/// The stream of lines that a user reads: stderr, with --quiet none.
std::ostream& diagnostics(Verbosity verbosity);

/// What is to be said of an input or a result.
struct Remark {
    Remark(std::string text_, std::string code_ = "") : text(std::move(text_)), code(std::move(code_)) {}
    std::string text;
    std::string code;  ///< of a warning, a short word that stays: "few_crystals"; "" of a note
};

/// Opens where events go. \param target number of an open descriptor, or a file, which is replaced
/// \throws UsageError for a descriptor that is not open for writing; OutputError for a file that cannot be written
void open_events(const std::string& target);
/// Leaves events to another process, the first of several ranks: `open_events` does nothing from here on.
void leave_events();

/// A line, and an event with it. What cannot be written on stderr, as on a full disk, is lost and does not end the
/// work. Nor does an event, unless its reader has closed the pipe: the work is then stopped as by SIGHUP.
void say(std::ostream& out, const std::string& line);
/// The line "SUBJECT: warning: TEXT", and an event with its code. \param file that the warning is of
void warn(std::ostream& out, const std::string& subject, const Remark& warning, const std::string& file = "");
/// An event of work in progress, for `Progress`. \param fraction of the work, 0 to 1
void tell_progress(const std::string& label, double fraction, const std::string& text);

/// Adds a value in SI units, or a word, to the last event.
void add_to_outcome(const std::string& name, double value);
void add_to_outcome(const std::string& name, const std::string& value);
/// Adds a file or folder that is there now to the last event.
void add_output_to_outcome(const std::string& path);
/// The last event. \param error the line of stderr by which the program fails, "" if it does not
void end_events(int exit_code, const std::string& error);

}  // namespace graincrack
