#include "post/ccd/design_options.hpp"

#include "post/options/common_options.hpp"
#include "share/options/command_line.hpp"

namespace graincrack {

namespace {

constexpr Quantity significance{"alpha", Dimension::one, 0, 1, "level of significance", true};

}  // namespace

void add_model(CLI::App& app, ccd::ModelOptions& options) {
    add_names(app, "--factor", options.factors, "NAME=LOW:HIGH", "factor with its values at -1 and +1, if the table has no x1");
    add_choice<bool>(app, "--model", options.choice.reduce, {{"full", false}, {"backward", true}},
                     "full: all quadratic terms; backward: reduced by backward elimination that keeps the hierarchy");
    add_quantity(app, "--alpha", options.choice.alpha, significance, "p value above which elimination removes a term", "0.1");
}

void add_goals(CLI::App& app, ccd::GoalOptions& options) {
    add_names(app, "--target", options.targets, "NAME=[LOW:]TARGET[:HIGH]",
              "wanted value of a response; limits default to the measured extremes");
    add_names(app, "--maximise", options.maxima, "NAME=LOW:GOOD",
              "response to be as large as possible: desirability 0 at LOW, 1 at GOOD");
    add_names(app, "--minimise", options.minima, "NAME=GOOD:HIGH",
              "response to be as small as possible: desirability 1 at GOOD, 0 at HIGH");
}

}  // namespace graincrack
