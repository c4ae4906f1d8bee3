#include "post/calibrate/outcome.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "share/base/quantities.hpp"

namespace graincrack::calibrate {

namespace {

using Json = nlohmann::ordered_json;  // NaN becomes null

/// {value, low, high, unit}, with null where there is none.
Json json_of(const Estimate& e, Dimension dimension) {
    const auto end = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
    return {{"value", e.value}, {"low", end(e.low)}, {"high", end(e.high)}, {"unit", si_unit(dimension)}};
}

Json targets_of(const Decision& decision) {
    Json targets = Json::object();
    for (const Outcome& o : decision.outcomes) {
        const Target& t = o.target;
        const Estimate ours = o.ours ? o.ours->mean : Estimate{NAN, std::nullopt, std::nullopt};
        Json& row = targets[t.name()] = json_of(ours, t.property.quantity.dimension);
        row.update({{"use", t.use == Use::fit ? "fit" : "predict"},
                    {"laboratory", t.value},
                    {"bound", t.deviation},
                    {"specimens", o.ours ? o.ours->n : 0},
                    {"tests", o.tests},
                    {"verdict", o.verdict}});
    }
    return targets;
}

/// What a reader of the numbers should know, each with a word for programs.
Json caveats_of(const Material& rock, const Problem& problem, const Decision& decision) {
    Json caveats = Json::array();
    const auto add = [&](const char* code, const std::string& of, const std::string& text) {
        caveats.push_back({{"code", code}, {"of", of}, {"text", text}});
    };
    for (const FoundValue& found : found_values(problem, decision)) {
        if (found.parameter != nullptr && !found.value.low) add("undetermined", found.key, "not determined by the data");
    }
    for (const Outcome& o : decision.outcomes) {
        const std::size_t n = o.ours ? o.ours->n : 0;
        if (n < o.tests) add("missing_values", o.target.name(), fmt::format("{} of {} tests have a value", n, o.tests));
        const std::string caveat = o.target.use == Use::fit ? "" : o.target.caveat(problem.study.specimens.bend());
        if (!caveat.empty()) add("other_specimen", o.target.name(), caveat);
    }
    if (const std::string text = disagreement_text(rock); !text.empty()) add("laboratory_disagrees", "uniaxial", text);
    return caveats;
}

}  // namespace

std::string outcome_text(const Material& rock, const Problem& problem, const Decision& decision,
                         const std::optional<Draws>& draws, std::size_t n_runs, const OutcomeFiles& files) {
    Json values = Json::object();
    for (const FoundValue& found : found_values(problem, decision)) {
        values[found.key] = json_of(found.value, material_quantity(found.key).dimension);
    }
    Json predictions = Json::object();
    for (const Prediction& p : draws ? predictions_of(*decision.fit, *draws) : std::vector<Prediction>()) {
        const Dimension dimension = p.target.property.quantity.dimension;
        predictions[p.target.name()] = {{"specimen", json_of(p.specimen, dimension)}, {"rock", json_of(p.rock, dimension)}};
    }
    const Json outcome{{"rock", rock.name},
                       {"state", decision.ending == Ending::requested ? "running" : label_of(decision.ending)},
                       {"reason", decision.reason},
                       {"next", decision.next},
                       {"runs", {{"finished", n_runs}, {"wanted", decision.requested.size()}}},
                       {"values", std::move(values)},
                       {"targets", targets_of(decision)},
                       {"predictions", std::move(predictions)},
                       {"caveats", caveats_of(rock, problem, decision)},
                       {"files", files}};
    return outcome.dump(2) + "\n";
}

}  // namespace graincrack::calibrate
