#include "post/ccd/design_options.hpp"

#include "post/options/command.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

constexpr Quantity significance{"alpha", Dimension::one, 0, 1, "level of significance", true};

}  // namespace

void add_model(OptionSet set, ccd::ModelOptions& options) {
    add_texts(set, "--factor", options.factors, "NAME=LOW:HIGH", "factor with its values at -1 and +1, if the table has no x1");
    add_choice<bool>(set, "--model", options.choice.reduce, {{"full", false}, {"backward", true}},
                     "full: all quadratic terms; backward: reduced by backward elimination that keeps the hierarchy");
    add_quantity(set, "--alpha", options.choice.alpha, significance, "p value above which elimination removes a term", "0.1");
}

void add_goals(OptionSet set, ccd::GoalOptions& options) {
    add_texts(set, "--target", options.targets, "NAME=[LOW:]TARGET[:HIGH]",
              "wanted value of a response; limits default to the measured extremes");
    add_texts(set, "--maximise", options.maxima, "NAME=LOW:GOOD",
              "response to be as large as possible: desirability 0 at LOW, 1 at GOOD");
    add_texts(set, "--minimise", options.minima, "NAME=GOOD:HIGH",
              "response to be as small as possible: desirability 1 at GOOD, 0 at HIGH");
}

}  // namespace graincrack
