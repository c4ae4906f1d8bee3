#include "post/commands/measures.hpp"

#include "post/measure/moduli.hpp"
#include "post/measure/rate_limit.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/measure/toughness.hpp"
#include "post/options/common_options.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

struct StrengthOptions {
    std::optional<TableFormat> format;
    StrengthKind kind = StrengthKind::first_peak;
    bool summary = false;
    bool extrapolate = false;
};

void add_strength_options(OptionSet set, StrengthOptions& options) {
    add_format(set, options.format);
    add_choice<StrengthKind>(
        set, "--strength", options.kind,
        {{name_of(StrengthKind::first_peak), StrengthKind::first_peak}, {name_of(StrengthKind::largest), StrengthKind::largest}},
        "strength of a confined test in the table for the terminal and in --summary: the first peak, as "
        "laboratories report it, or the largest stress; other tables have both");
    add_flag(set, "--summary", options.summary, "means over seeds for each test and confining pressure, UCS/BTS and DTS/BTS")
        .excludes(add_flag(set, "--extrapolate", options.extrapolate,
                           "extrapolate to slow loading from the same tests at two rates (--rate-tolerance or "
                           "--rate-share), with the error; changes above 5 % are refused"));
}

}  // namespace

Command strength_command() {
    return make_command<StrengthOptions>(
        "strength", "strength, strain and cracks at the peak and quality checks, one row per run",
        {"uniaxial.h5 brazilian.h5", "uniaxial.h5 triaxial.h5 brazilian.h5 --summary",
         "default.h5 half-as-fast.h5 --extrapolate"},
        several_runs, add_strength_options, [](const StrengthOptions& options, const Call& call) {
            const TableFormat format = format_for(options.format, call.out);
            if (options.extrapolate) return write_rate_limits(call.out, call.files, format);
            (options.summary ? write_strength_summary : write_strength_table)(call.out, call.files, format, call.diagnostics(),
                                                                              options.kind);
        });
}

Command moduli_command() {
    return make_command<std::optional<TableFormat>>(
        "moduli",
        "Young's modulus and Poisson's ratio (chord up to half the peak), predicted values, Voigt and Reuss bounds, crack "
        "thresholds; one row per run",
        {"uniaxial.h5", "uniaxial.h5 triaxial.h5 --format jsonl"}, several_runs,
        [](OptionSet set, std::optional<TableFormat>& format) { add_format(set, format); },
        [](const std::optional<TableFormat>& format, const Call& call) {
            write_moduli_table(call.out, call.files, format_for(format, call.out));
        });
}

Command toughness_command() {
    return make_command<TableFormat>(
        "toughness",
        "fracture toughness K_IC from direct tension of rectangles with a central notch, and from bending of notched beams and "
        "half-discs; one row per run",
        {"notched-tension.h5", "notched-tension.h5 --format jsonl"}, several_runs,
        [](OptionSet set, TableFormat& format) { add_format(set, format); },
        [](const TableFormat& format, const Call& call) {
            write_toughness_table(call.out, call.files, format, call.diagnostics());
        });
}

}  // namespace graincrack
