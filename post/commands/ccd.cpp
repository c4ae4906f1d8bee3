#include "post/commands/commands.hpp"

#include "post/ccd/tables.hpp"
#include "post/options/command.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

Command design_command() {
    using Options = ccd::DesignOptions;
    return make_command<Options>(
        "design", "the runs of a central composite design",
        {"--factor contact_cohesion_MPa=30:90 --factor contact_friction_angle_deg=45:61",
         "--factor contact_cohesion_MPa=30:90 --factor edge_mm=3:5 --star face-centred --centre-runs 3"},
        std::nullopt,
        [](OptionSet set, Options& options) {
            add_texts(set, "--factor", options.factors, "NAME=LOW:HIGH",
                      "factor with its values at the levels -1 and +1; its unit is part of its name");
            add_choice<ccd::Star>(set, "--star", options.star,
                                  {{"rotatable", ccd::Star::rotatable}, {"face-centred", ccd::Star::face_centred}},
                                  "position of the star points: at (2^k)^(1/4), or on the faces");
            add_integer<std::size_t>(set, "--centre-runs", options.centre_runs, "runs at the centre", 0, 1000);
        },
        [](const Options& options, const Call& call) { ccd::write_design(call.out, options, call.format); }, Prints::table);
}

Command fit_command() {
    using Options = ccd::FitOptions;
    return make_command<Options>(
        "fit", "quadratic response surfaces: coefficients, analysis of variance, lack of fit",
        {"table7.csv --response C_MPa --response phi_deg", "table7.csv --response C_MPa --model backward --table anova"},
        ccd::design_table,
        [](OptionSet set, Options& options) {
            using ccd::FitTable;
            ccd::add_model(set, options.model);
            add_texts(set, "--response", options.responses, "NAME", "column to fit; may be given again");
            add_choice<FitTable>(set, "--table", options.table,
                                 {{"terms", FitTable::terms}, {"anova", FitTable::anova}, {"summary", FitTable::summary}},
                                 "what to print");
        },
        [](const Options& options, const Call& call) { ccd::write_fit(call.out, call.file(), options, call.format); },
        Prints::table);
}

Command solve_command() {
    using Options = ccd::SolveOptions;
    return make_command<Options>(
        "solve", "factors at which the responses meet their goals (desirability), within the design",
        {"table7.csv --target C_MPa=21 --target phi_deg=53",
         "table7.csv --target phi_deg=53 --maximise C_MPa=10:30 --model backward --alpha 0.05"},
        ccd::design_table,
        [](OptionSet set, Options& options) {
            ccd::add_model(set, options.model);
            ccd::add_goals(set, options.goals);
        },
        [](const Options& options, const Call& call) { ccd::write_solution(call.out, call.file(), options, call.format); },
        Prints::table);
}

}  // namespace

Command ccd_command() {
    return make_group("ccd", "central composite designs: runs to make, response surfaces, optimal factors",
                      {design_command(), fit_command(), solve_command()});
}

}  // namespace graincrack
