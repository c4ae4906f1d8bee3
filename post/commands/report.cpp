#include "post/commands/report.hpp"

#include "post/cracks/crack_options.hpp"
#include "post/fit/fit_options.hpp"
#include "post/options/common_options.hpp"
#include "post/report/report.hpp"
#include "share/file/output_file.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

Command report_command() {
    struct Options {
        ReportOptions report;
        std::string material;
        std::string page;
    };
    return make_command<Options>(
        "report", "report of one test or of a set of tests as a self-contained HTML page",
        {"uniaxial.h5 -o page.html", "uniaxial.h5 triaxial.h5 brazilian.h5 --material augig-granite -o page.html"}, several_runs,
        [](OptionSet set, Options& options) {
            add_text(set, "--material", options.material,
                     "material with the laboratory values and targets to compare with; default: that of the first run, if it "
                     "is found where the run names it");
            add_strain_limit_runs(set, options.report.strain_limit_runs);
            add_crack_label(set, options.report.label);
            add_output(set, options.page, "page: .html");
        },
        [](const Options& options, const Call& call) {
            require_ending(options.page, ".html");
            ReportOptions report = options.report;
            if (!options.material.empty()) report.material = read_material_of(call, options.material);
            write_whole_file(options.page, make_report(call.files, report, call.verbosity));
        });
}

}  // namespace graincrack
