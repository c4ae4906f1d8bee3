#include "post/commands/claims.hpp"

#include <fmt/format.h>

#include "post/claims/claims_table.hpp"
#include "post/options/common_options.hpp"
#include "share/base/error.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

struct ClaimsCommandOptions {
    std::string study;
    std::vector<std::string> settings;
    claims::ClaimsFormat format = claims::ClaimsFormat::tsv;
};

void write_verdicts(const ClaimsCommandOptions& options, const Call& call) {
    if (call.files.size() < 2) {
        throw UsageError("tables: missing; claims needs the file of claims and the tables of results that it names");
    }
    claims::ClaimsOptions parts{options.study, {}, options.format};
    for (const std::string& text : options.settings) {
        const std::size_t at = text.find('=');
        if (at == 0 || at == std::string::npos) throw UsageError(fmt::format("--set {}: NAME=VALUE is needed", text));
        parts.settings[text.substr(0, at)] = text.substr(at + 1);
    }
    claims::write_claims(call.out, call.files.front(), {call.files.begin() + 1, call.files.end()}, parts);
}

}  // namespace

Command claims_command() {
    using Format = claims::ClaimsFormat;
    return make_command<ClaimsCommandOptions>(
        "claims", "compare the claims of a paper with tables of results: verdicts with intervals",
        {"claims.tsv properties.tsv modes.tsv --study verification", "claims.tsv properties.tsv --set BTS=8.8 --format markdown"},
        FileArguments{"files", "the file of claims, then the tables of results that it names"},
        [](OptionSet set, ClaimsCommandOptions& options) {
            add_text(set, "--study", options.study, "name of the study, in the first column");
            add_texts(set, "--set", options.settings, "NAME=VALUE",
                      "text that replaces {NAME} in the claims; may be given again");
            add_choice<Format>(set, "--format", options.format,
                               {{"table", Format::aligned},
                                {"tsv", Format::tsv},
                                {"jsonl", Format::jsonl},
                                {"markdown", Format::markdown},
                                {"html", Format::html}},
                               "form of the table");
        },
        &write_verdicts);
}

}  // namespace graincrack
