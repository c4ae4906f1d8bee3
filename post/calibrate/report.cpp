#include "post/calibrate/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "post/measure/toughness.hpp"
#include "share/base/quantities.hpp"
#include "share/base/units.hpp"

namespace graincrack::calibrate {

namespace {

using Cells = std::vector<std::string>;

std::string markdown_row(const Cells& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }
std::string markdown_head(const Cells& cells) {
    std::string rule = "|";
    for (std::size_t i = 0; i < cells.size(); ++i) rule += "---|";
    return "\n" + markdown_row(cells) + rule + "\n";
}

/// A value of a material that a calibration found, SI.
struct FoundValue {
    std::string key;
    Estimate value;                        ///< without an interval where it was scaled, or the data do not determine it
    const Parameter* parameter = nullptr;  ///< null of E and ν of the grains
};
std::vector<FoundValue> found_values(const Problem& problem, const Decision& decision) {
    std::vector<FoundValue> all;
    for (const auto& [key, value] : decision.point) {
        FoundValue& found = all.emplace_back(FoundValue{key, {value, std::nullopt, std::nullopt}});
        for (std::size_t k = 0; k < problem.parameters.size(); ++k) {
            const Parameter& p = problem.parameters[k];
            if (p.key != key) continue;
            found.parameter = &p;
            const auto i = static_cast<Eigen::Index>(k);
            const Optimum& optimum = decision.fit->optimum;
            if (optimum.is_undetermined(i)) continue;
            found.value.low = p.value(optimum.point(i) - optimum.half_interval(i));
            found.value.high = p.value(optimum.point(i) + optimum.half_interval(i));
        }
    }
    return all;
}

std::string percent(double part) { return std::isfinite(part) ? fmt::format("{:.2g} %", 100 * part) : ""; }

std::string count_of(std::size_t n, const char* one, const char* several, const Cells& names) {
    return fmt::format("{} {}{}{}", n, n == 1 ? one : several, n == 0 ? "" : ": ", fmt::join(names, ", "));
}

/// On what K_IC was tested, and on what the laboratory measured it.
std::string toughness_test_text(const Problem& problem) {
    const auto toughness = std::ranges::find_if(problem.targets, [](const Target& t) { return t.property.name == "toughness"; });
    if (toughness == problem.targets.end()) return "K_IC was not tested";
    const ToughnessTest tested = problem.study.specimens.bend();
    const std::string text = "K_IC was tested on: " + tested.text();
    if (toughness->caveat(tested).empty()) return text + ", as in the laboratory";
    return fmt::format("{}; the laboratory's is {}", text, toughness->measured_on->text());
}

/// True if K_IC of a rock is what `take_laboratory` makes of its tensile strength.
bool is_assumed_toughness(const Material& rock) {
    const double assumed = rock.rock.tensile_strength / fpz::tensile_strength_from_toughness(1);
    return !rock.laboratory_value("mode_i_toughness") && rock.rock.mode_i_toughness == assumed;
}

/// How many free parameters, targets of both kinds and first peaks there are, what became of K_IC, and what is fixed.
std::string summary_text(const Findings& findings, const std::optional<Material>& at) {
    const auto& [rock, problem, decision, n_runs, sensitivities, draws, predictions] = findings;
    Cells parameters;
    for (const Parameter& p : problem.parameters) parameters.push_back(p.key);
    Cells fitted;
    Cells predicted;
    Cells others;
    for (const Target& t : problem.targets) {
        (t.use == Use::fit ? fitted : std::isfinite(t.value) ? predicted : others).push_back(t.symbol());
    }
    std::string text =
        fmt::format("- {}\n- {}\n- {}\n", count_of(parameters.size(), "free parameter", "free parameters", parameters),
                    count_of(fitted.size(), "fitted target", "fitted targets", fitted),
                    count_of(predicted.size(), "predicted target", "predicted targets", predicted));
    if (!others.empty()) {
        text += fmt::format(
            "- {}\n", count_of(others.size(), "property without a measured value", "properties without measured values", others));
    }
    if (at) {
        const ContactParameters contact = contact_parameters(*at, PlaneCondition::strain, std::nullopt);
        const double energy = total_fracture_energy(contact);
        const double toughness = std::sqrt(fpz::effective_modulus(at->rock, PlaneCondition::strain) * energy);
        text += fmt::format(
            "- {}. The fracture energy of contacts, {:.4g} J/m², corresponds to √(Ẽ G) = {:.3g} "
            "MPa √m; {} {:.3g} MPa √m\n",
            toughness_test_text(problem), energy, toughness * 1e-6,
            is_assumed_toughness(rock) ? "K_IC was not measured, and σt/6.88 is" : "the rock has",
            rock.rock.mode_i_toughness * 1e-6);
        Cells fixed;
        for (const ContactParameter& row : all_contact_parameters()) {
            const std::string key = "contact." + row.key();
            if (std::ranges::find(parameters, key) != parameters.end()) continue;
            const bool given = (at->contact.*row.given).has_value();
            if (contact.*row.value == 0 && !given) continue;
            fixed.push_back(fmt::format("{} {}{}", key, value_text(key, contact.*row.value, " "), given ? "" : " (derived)"));
        }
        if (!at->fabric.phases.empty()) fixed.push_back(fmt::format("phases.contrast {:g}", at->fabric.contrast));
        text += fmt::format("- fixed (contacts in plane strain): {}\n", fmt::join(fixed, ", "));
    }
    Cells peaks;
    if (decision.fit) {
        for (const Response& r : decision.fit->responses) {
            if (r.target.property.needs_first_peak && !decision.fit->points.empty()) {
                peaks.push_back(fmt::format("{} in {} of {} tests", r.target.symbol(), r.measured, r.tests));
            }
        }
        for (const Outcome& o : decision.outcomes) {
            if (o.target.property.needs_first_peak) {
                peaks.push_back(fmt::format("at the end {} in {} of {}", o.target.symbol(), o.ours ? o.ours->n : 0, o.tests));
            }
        }
    }
    text += fmt::format("- first peaks: {}\n- {} runs; compression at a rate tolerance of {:g}, to {:.3g} % strain at most\n",
                        peaks.empty() ? "not tested" : fmt::format("{}", fmt::join(peaks, "; ")), n_runs,
                        problem.study.rate_tolerance, 100 * problem.study.max_strain);
    const std::string disagreeing = disagreement_text(rock);
    return text + (disagreeing.empty() ? "" : fmt::format("- {}; C is not fitted\n", disagreeing));
}

std::string outcomes_text(const Decision& decision) {
    std::string text =
        markdown_head({"target", "asked", "laboratory", "new specimens", "tests with it", "off", "bound", "verdict"});
    for (const Outcome& o : decision.outcomes) {
        const Target& t = o.target;
        const bool known = std::isfinite(t.value);
        const double scale = t.property.absolute ? 1 : 100 / t.value;
        const char* unit = t.property.absolute ? "" : " %";
        const std::string on_line = t.is_on_line ? fmt::format(" ({})", no_test) : "";
        text += markdown_row({t.symbol() + (t.property.unit.empty() ? "" : ", " + t.property.unit),
                              t.use == Use::fit ? "fitted"
                              : known           ? "predicted"
                                                : "not measured",
                              known ? fmt::format("{:.5g}", t.value / t.property.si) + on_line : "",
                              o.ours ? with_interval(o.ours->mean, t.property.si) : "",
                              fmt::format("{} of {}", o.ours ? o.ours->n : 0, o.tests),
                              known && o.ours ? fmt::format("{:+.3g}{}", (o.ours->mean.value - t.value) * scale, unit) : "",
                              known ? fmt::format("± {:.3g}{}", t.deviation * scale, unit) : "", o.verdict});
    }
    return text;
}

std::string values_text(const Problem& problem, const Decision& decision) {
    std::string text = markdown_head({"parameter", "value", "95 % interval", "first guess", "first box", "limits", "source"});
    const Optimum& optimum = decision.fit->optimum;
    for (const FoundValue& found : found_values(problem, decision)) {
        const auto in = [&](double v) { return value_text(found.key, v, " "); };
        const auto between = [&](double low, double high) { return fmt::format("{} to {}", in(low), in(high)); };
        const Parameter* const p = found.parameter;
        Cells cells{found.key, in(found.value.value)};
        if (p == nullptr) {
            cells.insert(cells.end(), {"", "", "", "", "scaled until the assemblage has the value of the rock"});
        } else {
            const auto& [value, low, high] = found.value;
            cells.insert(cells.end(), {low ? between(*low, *high) : "not determined by the data", in(p->first),
                                       between(p->low, p->high), between(p->least, p->most), p->source});
        }
        text += markdown_row(cells);
    }
    text +=
        "\nIntervals include the scatter about the response surfaces, the uncertainty of the measured values (the deviations of "
        "the "
        "targets), and what is known beforehand: the first guess, with a standard deviation of " +
        (optimum.prior == 1 ? "" : fmt::format("{:g} times ", optimum.prior)) +
        "half the width of the first box. A value is not determined by the data where they leave more than half of that half "
        "width: it is then nearly that of the first guess, of the kind of rock.\n";
    text += std::isfinite(optimum.condition)
                ? fmt::format("\nCondition number of the sensitivities: {:.3g}.", optimum.condition)
                : "\nThere are fewer fitted targets beside E and ν, which scale the grains, than parameters.";
    Cells pairs;
    for (Eigen::Index k = 0; k < optimum.point.size(); ++k) {
        for (Eigen::Index l = 0; l < k; ++l) {
            const double c = optimum.covariance(k, l) / std::sqrt(optimum.covariance(k, k) * optimum.covariance(l, l));
            if (std::isfinite(c) && !optimum.is_undetermined(k) && !optimum.is_undetermined(l)) {
                pairs.push_back(fmt::format("{} and {} {:+.2f}", problem.parameters[static_cast<std::size_t>(l)].key,
                                            problem.parameters[static_cast<std::size_t>(k)].key, c));
            }
        }
    }
    return text + (pairs.empty() ? "\n" : fmt::format(" Correlations: {}.\n", fmt::join(pairs, ", ")));
}

std::string surfaces_text(const Fit& fit) {
    std::string text =
        "\nLeast-squares fits of ln(response) in the last box, for a drop of what is left behind it. Scatter is the standard "
        "deviation about the surface; √(PRESS/n) "
        "is the same for values predicted without their own test. A surface of the kind is of its design and of this rock.\n";
    text += markdown_head({"response", "values", "quadratic terms", "scatter", "√(PRESS/n)", "at the optimum"});
    for (const Response& r : fit.responses) {
        if (!r.surface && r.tests == 0) continue;
        if (!r.surface) {
            text += markdown_row(
                {r.target.symbol(), fmt::format("no surface; {} of {} tests have a value", r.measured, r.tests), "", "", "", ""});
            continue;
        }
        const LinearModel& m = r.surface->model();
        const auto n_quadratic = std::ranges::count_if(m.terms, [](const SurfaceTerm& t) { return t.degree() > 1; });
        text += markdown_row({r.target.symbol(), std::to_string(m.n_values), std::to_string(n_quadratic), percent(m.scatter()),
                              percent(m.prediction_error()),
                              r.target.text(r.target.of_logarithm(r.surface->value(fit.optimum.point)))});
    }
    return text;
}

/// What new specimens have by kind and runs, at the values found, and the rock whatever its values.
std::string predictions_text(const std::vector<Prediction>& predictions) {
    std::string text =
        "\nBy the kind and the runs of this rock: what a new specimen has at the values found, with 50 and 95 % intervals, and "
        "the "
        "95 % interval of the mean of the rock, whose values are not known better than the targets tell (draws.tsv).\n";
    text += markdown_head({"property", "at these values", "50 %", "95 %", "rock, 95 %"});
    for (const Prediction& p : predictions) {
        const Target& t = p.target;
        const auto interval = [&](const Estimate& e) { return fmt::format("{} to {}", t.text(*e.low), t.text(*e.high)); };
        text += markdown_row(
            {t.symbol(), t.text(p.rock.value), interval(p.half_of_specimens), interval(p.specimen), interval(p.rock)});
    }
    return text;
}

std::vector<Sensitivity> sensitivities_of(const std::vector<Parameter>& parameters, const Fit& fit) {
    std::vector<Sensitivity> all;
    const DesignPoint& point = fit.optimum.point;
    for (const Response& response : fit.responses) {
        if (!response.surface) continue;
        const DesignPoint gradient = response.surface->gradient(point);
        const Eigen::MatrixXd covariance = response.surface->gradient_covariance(point);
        for (Eigen::Index k = 0; k < point.size(); ++k) {
            const Parameter& p = parameters[static_cast<std::size_t>(k)];
            const double by_log = p.coordinate_by_log(p.value(point(k)));
            all.push_back(
                {response.target.symbol(), p.key,
                 estimate(gradient(k) * by_log, covariance(k, k) * by_log * by_log, response.surface->model().freedom)});
        }
    }
    return all;
}

using Json = nlohmann::ordered_json;  // NaN becomes null

/// {value, low, high, unit}, with null where there is none.
Json json_of(const Estimate& e, Dimension dimension) {
    const auto end = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
    return {{"value", e.value}, {"low", end(e.low)}, {"high", end(e.high)}, {"unit", si_unit(dimension)}};
}

Json json_of_targets(const Decision& decision) {
    Json targets = Json::object();
    for (const Outcome& o : decision.outcomes) {
        const Target& t = o.target;
        const Estimate ours = o.ours ? o.ours->mean : Estimate{NAN, std::nullopt, std::nullopt};
        Json& row = targets[t.name()] = json_of(ours, t.property.quantity.dimension);
        row.update({{"symbol", t.symbol()},
                    {"display_unit", t.property.unit},
                    {"display_si", t.property.si},
                    {"use", t.use == Use::fit ? "fit" : "predict"},
                    {"laboratory", t.value},
                    {"bound", t.deviation},
                    {"bound_is_relative", !t.property.absolute},
                    {"specimens", o.ours ? o.ours->n : 0},
                    {"tests", o.tests},
                    {"verdict", o.verdict}});
    }
    return targets;
}

/// What a reader of the numbers should know, each with a word for programs.
Json json_of_caveats(const Findings& findings) {
    const auto& [rock, problem, decision, n_runs, sensitivities, draws, predictions] = findings;
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

std::vector<Prediction> predictions_of(const Fit& fit, const Draws& draws) {
    std::vector<Prediction> all;
    for (std::size_t r = 0; r < fit.responses.size(); ++r) {
        if (!fit.responses[r].surface) continue;
        const Target& t = fit.responses[r].target;
        const LocalSurface& surface = *fit.responses[r].surface;
        const double mean = surface.value(fit.optimum.point);
        const double deviation = std::hypot(surface.model().scatter(), std::sqrt(surface.variance(fit.optimum.point)));
        const auto between = [&](double low, double high) {
            return Estimate{t.of_logarithm(mean), t.of_logarithm(low), t.of_logarithm(high)};
        };
        const auto around = [&](double deviations) {
            return between(mean - deviations * deviation, mean + deviations * deviation);
        };
        std::vector<double> logs;
        for (const std::vector<double>& draw : draws.logs) logs.push_back(draw[r]);
        std::ranges::sort(logs);
        const std::size_t outside = logs.size() / 40;
        all.push_back({t, around(deviations_of_50_percent), around(deviations_of_95_percent),
                       between(logs[outside], logs[logs.size() - 1 - outside])});
    }
    return all;
}

Findings findings_of(const Material& rock, const Problem& problem, const Decision& decision, std::size_t n_runs) {
    Findings findings{rock, problem, decision, n_runs};
    if (decision.ending == Ending::requested || !decision.fit) return findings;
    const Fit& fit = *decision.fit;
    findings.sensitivities = sensitivities_of(problem.parameters, fit);
    if (!fit.points.empty()) return findings;  // of a rock without a kind
    std::vector<const LocalSurface*> surfaces;
    for (const Response& r : fit.responses) surfaces.push_back(r.surface ? &*r.surface : nullptr);
    findings.draws = draw(limits_of(problem.parameters), fit.optimum, residuals_of(fit.responses), surfaces, 400);
    findings.predictions = predictions_of(fit, *findings.draws);
    return findings;
}

std::string draws_table(const Findings& findings) {
    const Fit& fit = *findings.decision.fit;
    const Draws& draws = *findings.draws;
    const std::vector<Parameter>& parameters = findings.problem.parameters;
    std::string text = "draw";
    for (const Parameter& p : parameters) text += "\t" + column_of(p.key);
    for (const Response& r : fit.responses) {
        if (r.surface) text += fmt::format("\t{}_{}", r.target.name(), r.target.property.unit);
    }
    for (std::size_t i = 0; i < draws.points.size(); ++i) {
        text += fmt::format("\n{}", i + 1);
        for (const auto& [key, value] : point_at(parameters, draws.points[i])) {
            text += fmt::format("\t{:.5g}", in_unit(key, value));
        }
        for (std::size_t r = 0; r < fit.responses.size(); ++r) {
            const Target& t = fit.responses[r].target;
            if (fit.responses[r].surface) text += fmt::format("\t{:.5g}", t.of_logarithm(draws.logs[i][r]) / t.property.si);
        }
    }
    return text + "\n";
}

std::string identify_table(const std::vector<Sensitivity>& sensitivities) {
    std::string text = "response\tparameter\texponent\texponent_low\texponent_high\n";
    for (const Sensitivity& s : sensitivities) {
        text += fmt::format("{}\t{}\t{:.4g}\t{:.4g}\t{:.4g}\n", s.response, s.parameter, s.exponent.value, *s.exponent.low,
                            *s.exponent.high);
    }
    return text;
}

std::string with_interval(const Estimate& e, double si) {
    if (!e.low || !e.high) return fmt::format("{:.5g}", e.value / si);
    return fmt::format("{:.5g} ({:.5g} to {:.5g})", e.value / si, *e.low / si, *e.high / si);
}

std::string report_text(const Findings& findings, const std::optional<Material>& at) {
    const Decision& decision = findings.decision;
    std::string text = fmt::format("# {}: {}\n\n{}.\n\nNext: {}.\n\n", findings.rock.name, label_of(decision.ending),
                                   decision.reason, decision.next);
    text += summary_text(findings, at);
    if (!decision.outcomes.empty()) text += "\n## Targets\n" + outcomes_text(decision);
    if (decision.fit) {
        text += "\n## Values\n" + values_text(findings.problem, decision);
        if (findings.draws) text += "\n## Predictions\n" + predictions_text(findings.predictions);
        text += "\n## Surfaces\n" + surfaces_text(*decision.fit);
        text +=
            "\n## What tells what\n\nd ln(response)/d ln(parameter) at the optimum, for a drop of what is left; identify.tsv "
            "has them with 95 % intervals.\n\n";
    }
    text += "\n## Steps\n" + markdown_head({"stage", "what", "result"});
    for (const Step& step : decision.steps) text += markdown_row({step.stage, step.what, step.result});
    return text;
}

std::string outcome_text(const Findings& findings, const std::map<std::string, std::string>& files) {
    const Decision& decision = findings.decision;
    Json values = Json::object();
    for (const FoundValue& found : found_values(findings.problem, decision)) {
        Json& row = values[found.key] = json_of(found.value, material_quantity(found.key).dimension);
        const DisplayUnit display = display_unit(found.key);
        row.update({{"first_guess", found.parameter != nullptr ? Json(found.parameter->first) : Json()},
                    {"display_unit", display.symbol},
                    {"display_si", display.si}});
    }
    Json predictions = Json::object();
    for (const Prediction& p : findings.predictions) {
        const Dimension dimension = p.target.property.quantity.dimension;
        predictions[p.target.name()] = {{"specimen", json_of(p.specimen, dimension)}, {"rock", json_of(p.rock, dimension)}};
    }
    const Json outcome{{"rock", findings.rock.name},
                       {"state", decision.ending == Ending::requested ? "running" : label_of(decision.ending)},
                       {"reason", decision.reason},
                       {"next", decision.next},
                       {"runs", {{"finished", findings.n_runs}, {"wanted", decision.requested.size()}}},
                       {"values", std::move(values)},
                       {"targets", json_of_targets(decision)},
                       {"predictions", std::move(predictions)},
                       {"caveats", json_of_caveats(findings)},
                       {"files", files}};
    return outcome.dump(2) + "\n";
}

}  // namespace graincrack::calibrate
