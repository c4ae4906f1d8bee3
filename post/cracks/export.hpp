// The command `cracks`: a run as a folder of files for ParaView and scripts.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/cracks/emission.hpp"
#include "post/options/command.hpp"
#include "post/run/crack_label.hpp"
#include "share/base/progress.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// The window of an acoustic event; unset values are `default_window`'s.
struct EventOptions {
    std::optional<double> distance;  ///< m
    std::optional<double> time;      ///< s
};

/// Options of the export.
struct CrackExportOptions {
    EventOptions events;
    CrackLabelChoice label;                 ///< of the maps, the rosette and the counts
    TableFormat format = TableFormat::tsv;  ///< of the tables, whose names then end in .jsonl
};

/// Writes `folder`/{grains.pvd, cracks.pvd} with the frames they name, and the tables cracks.tsv, rosette.tsv, summary.tsv,
/// classes.tsv, events.tsv, fragments.tsv, of a specimen with crystals of several grains
/// crystals.tsv; the .pvd files last, so that a series that exists is complete. A run whose axial stress never rises has no
/// peak in summary.tsv. \throws InputError for a run without frames, OutputError
void export_cracks(const RunReader& run, const std::string& folder, const CrackExportOptions& options, Verbosity verbosity);

/// The crack log, every column with its unit; the class of the contact where the specimen has several phases.
void write_crack_table(std::ostream& out, const std::vector<Crack>& log, const Specimen& specimen, TableFormat format);

/// --crack-event failed|half-damaged|broken, --crack-mode traction|sign: what counts as a micro-crack, and which are tensile.
void add_crack_label(OptionSet set, CrackLabelChoice& label);

}  // namespace graincrack
