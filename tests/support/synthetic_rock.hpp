// A rock whose tests cost nothing: powers of its parameters with some curvature, and the scatter of real tests.
#pragma once

#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <string>

#include "post/calibrate/decide.hpp"
#include "tests/support/normal.hpp"

namespace graincrack::test {

/// Exponents of the parameters, relative to a reference, of one response, and how far equal tests scatter (of the ln).
struct SyntheticResponse {
    double reference = 0;  ///< in the unit of its column
    std::map<std::string, double> exponents;
    double scatter = 0;
    double curvature = 0;  ///< of ln cc
};

struct SyntheticRock {
    std::map<std::string, SyntheticResponse> responses;  ///< by test and pressure with the column: "triaxial8MPa first_peak_MPa"
    std::map<std::string, double> reference;             ///< of the parameters, SI
    double scatter = 1;                                  ///< times that of the responses
    std::uint32_t stream = 0;                            ///< of the scatter
    std::function<bool(const calibrate::RequestedRun&)> has_peak = [](const calibrate::RequestedRun&) { return true; };

    /// ln of a response without scatter.
    [[nodiscard]] static double log_of(const SyntheticResponse& response, const std::map<std::string, double>& logs) {
        double sum = std::log(response.reference);
        for (const auto& [key, exponent] : response.exponents) sum += exponent * logs.at(key);
        return sum + response.curvature * std::pow(logs.at("contact.cohesion"), 2);
    }
    [[nodiscard]] std::map<std::string, double> logs_of(const calibrate::Point& point) const {
        std::map<std::string, double> logs;
        for (const auto& [key, value] : point) {
            if (const auto to = reference.find(key); to != reference.end()) logs[key] = std::log(value / to->second);
        }
        return logs;
    }
    [[nodiscard]] calibrate::Measures measure(const calibrate::RequestedRun& run) const {
        calibrate::Measures measures;
        const auto logs = logs_of(run.point);
        std::uint32_t column = 0;
        for (const auto& [name, response] : responses) {
            ++column;
            const std::string test = run.test.label() + " ";
            if (!name.starts_with(test)) continue;
            const std::string key = name.substr(test.size());
            if (key == "first_peak_MPa" && !has_peak(run)) continue;
            Normal normal(static_cast<std::uint32_t>(run.seed) * 7919U + column * 104729U + stream * 1299709U);
            measures[key] = std::exp(log_of(response, logs) + scatter * response.scatter * normal());
        }
        // Assemblages are 5 % softer than their grains.
        for (const auto& [key, value] : run.point) {
            if (key == "rock.young_modulus") measures["young_modulus_GPa"] = 0.95e-9 * value;
            if (key == "rock.poisson_ratio") measures["poisson_ratio"] = value + 0.01;
        }
        measures["wall_time_s"] = 6;
        return measures;
    }
    /// A rock with five parameters and eight responses beside E and ν: discs scatter by 9.5 %, rectangles by 4 %.
    static SyntheticRock usual() {
        const std::string tc = "contact.tensile_strength";
        const std::string cc = "contact.cohesion";
        const std::string phi = "contact.friction_angle";
        const std::string residual = "contact.residual_friction_angle";
        const std::string gf = "contact.fracture_energy";
        SyntheticRock rock;
        rock.reference = {{tc, 8e6}, {cc, 40e6}, {phi, 0.75}, {residual, 0.6}, {gf, 60}};
        rock.responses = {{"brazilian tensile_strength_MPa", {8.8, {{tc, 0.5}, {gf, 0.5}}, 0.095}},
                          {"tension tensile_strength_MPa", {7, {{tc, 0.9}, {gf, 0.1}}, 0.04}},
                          {"uniaxial first_peak_MPa", {122, {{cc, 0.6}, {phi, 0.5}, {tc, 0.1}}, 0.04, 0.1}},
                          {"uniaxial crack_initiation_MPa", {55, {{tc, 0.4}, {cc, 0.3}, {gf, 0.2}}, 0.07}},
                          {"triaxial4MPa first_peak_MPa", {157, {{cc, 0.5}, {phi, 0.8}}, 0.03, 0.1}},
                          {"triaxial8MPa first_peak_MPa", {193, {{cc, 0.4}, {phi, 1.1}}, 0.04, 0.15}},
                          {"triaxial8MPa residual_MPa", {150, {{residual, 1.2}, {phi, 0.2}}, 0.05}},
                          {"triaxial20MPa first_peak_MPa", {290, {{cc, 0.3}, {phi, 1.5}}, 0.02}}};
        return rock;
    }
    /// Its parameters, each in a box of ±50 % or so, and its targets with the values that a design point of the box gives.
    [[nodiscard]] calibrate::Problem problem(const std::map<std::string, double>& planted_logs,
                                             Normal* laboratory = nullptr) const {
        calibrate::Problem problem;
        problem.young_modulus = 25.8e9;
        problem.poisson_ratio = 0.23;
        for (const auto& [key, value] : reference) {
            const bool angle = key.ends_with("angle");
            const double factor = angle ? 1.3 : 1.8;
            problem.parameters.push_back(
                {key, !angle, value / factor, value * factor, value / factor / factor, value * factor * factor, value, "given"});
        }
        const auto add = [&](const std::string& name, double value) {
            problem.targets.push_back(calibrate::target_of(name, "targets"));
            calibrate::Target& t = problem.targets.back();
            t.value = value;
            t.deviation = t.property.deviation * (t.property.absolute ? 1 : value);
            t.use = calibrate::Use::fit;
            if (laboratory != nullptr && !t.is_elastic()) t.value *= std::exp(t.log_deviation() * (*laboratory)());
        };
        add("young_modulus", 25.8e9);
        add("poisson_ratio", 0.23);
        const std::map<std::string, std::string> names{{"brazilian tensile_strength_MPa", "brazilian"},
                                                       {"tension tensile_strength_MPa", "direct_tension"},
                                                       {"uniaxial first_peak_MPa", "uniaxial"},
                                                       {"uniaxial crack_initiation_MPa", "crack_initiation"},
                                                       {"triaxial4MPa first_peak_MPa", "first_peak_4MPa"},
                                                       {"triaxial8MPa first_peak_MPa", "first_peak_8MPa"},
                                                       {"triaxial8MPa residual_MPa", "residual_8MPa"},
                                                       {"triaxial20MPa first_peak_MPa", "first_peak_20MPa"}};
        for (const auto& [name, response] : responses) add(names.at(name), 1e6 * std::exp(log_of(response, planted_logs)));
        return problem;
    }
};

/// Makes each run when it is asked for, and keeps it.
class Laboratory {
public:
    explicit Laboratory(SyntheticRock rock) : rock_(std::move(rock)) {}
    calibrate::FindRun find() {
        return [this](const calibrate::RequestedRun& run) { return &made_.emplace_back(rock_.measure(run)); };
    }
    [[nodiscard]] std::size_t n_runs() const { return made_.size(); }

private:
    SyntheticRock rock_;
    std::deque<calibrate::Measures> made_;
};

}  // namespace graincrack::test
