// The surface of a kind from planted rows: what it finds, where it holds, of which materials it is, and broken tables.
#include "post/kind/kind_surface.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"
#include "tests/support/synthetic_kind.hpp"

namespace graincrack {
namespace {

using test::SyntheticKind;

const Property& uniaxial = property_named("uniaxial");
const Property& toughness = property_named("toughness");
const Property& first_peak = property_named("first_peak");

std::vector<KindRow> granite_and_gabbro(const SyntheticKind& planted) {
    std::vector<KindRow> rows = planted.rows(70);
    for (const KindRow& row : planted.rows(20, 2, "gabbro")) {
        if (row.property != "toughness") rows.push_back(row);
    }
    return rows;
}

TEST(KindSurface, FindsWhatWasPlanted) {
    const SyntheticKind planted;
    for (const char* kind : {"granite", "gabbro"}) {
        const KindSurface surface(granite_and_gabbro(planted), kind);
        const double of_kind = surface.kind() == "gabbro" ? planted.of_gabbro : 0;
        for (const KindRow& row : SyntheticKind{}.rows(20, 3)) {
            if (!surface.holds(row.at, row.confining_pressure)) continue;
            const auto found = surface.predict(row.at, property_named(row.property), row.confining_pressure);
            ASSERT_EQ(found.has_value(), of_kind == 0 || row.property != "toughness");  // no gabbro has a row of that
            if (!found) continue;
            EXPECT_NEAR(std::log(found->value), planted.log_of(row.property, row.at, row.confining_pressure) + of_kind, 0.1);
            EXPECT_GT(found->mean_deviation, 0.03);  // what rocks differ by, at least
            EXPECT_NEAR(found->specimen_at(1.96), found->value * std::exp(1.96 * found->specimen_deviation), 1e-12);
        }
        const KindModel& model = *surface.model(uniaxial, 0);
        EXPECT_NEAR(std::sqrt(model.variance), planted.scatter, 0.01);
        EXPECT_EQ(model.n_values, 90);
        EXPECT_EQ(model.rock_variance, 0.03 * 0.03);
        EXPECT_EQ(surface.name_of(model.terms[1]), "ln(cohesion/5)");
        EXPECT_EQ(surface.model(uniaxial, 5e6), nullptr);
        EXPECT_EQ(surface.model(first_peak, 0), nullptr);
        EXPECT_EQ(surface.model(property_named("drop"), 5e6), nullptr);
    }
    test::GoldenRefusals().add<InputError>("8 rows", [&] { KindSurface(planted.rows(8), "granite"); });
}

TEST(KindSurface, HasIntervalsThatHoldNewSpecimens) {
    const SyntheticKind planted;
    int n = 0, within = 0;
    double deviations = 0;  // of means, squared
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const KindSurface surface(planted.rows(60, seed), "granite");
        for (const KindRow& row : planted.rows(10, 100 + seed)) {
            const auto found = surface.predict(row.at, property_named(row.property), row.confining_pressure);
            if (!found) continue;
            const double of_rocks = 0.03 * 0.03;  // these rows have none
            const double off = planted.log_of(row.property, row.at, row.confining_pressure) - std::log(found->value);
            const double deviation = std::sqrt(std::pow(found->specimen_deviation, 2) - of_rocks);
            within += std::abs(std::log(row.value / found->value)) < 1.96 * deviation ? 1 : 0;
            deviations += off * off / (std::pow(found->mean_deviation, 2) - of_rocks);
            ++n;
        }
    }
    EXPECT_GT(n, 600);
    EXPECT_NEAR(1.0 * within / n, 0.95, 0.02);
    EXPECT_NEAR(std::sqrt(deviations / n), 1, 0.15);
}

// Of four kinds on the six specimens of granite, four fifths of the variance are of the specimen.
TEST(KindSurface, TakesRunsOfOtherKindsOnOneSpecimenForThatSpecimen) {
    const SyntheticKind exact{.scatter = 0};
    double off = 0;  // over the deviation, squared
    double together = 0, apart = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        test::Normal normal(seed);
        std::vector<KindRow> rows, with_own_names;
        std::vector<KindCoordinates> six;
        for (const KindRow& row : exact.rows(60, seed)) {
            if (row.property != "uniaxial") continue;
            const double of_specimen = std::sqrt(0.8) * normal();
            const bool is_of_all = six.size() < 6;
            if (is_of_all) six.push_back(row.at);
            for (const char* kind : {"granite", "gabbro", "marble", "quartzite"}) {
                rows.push_back(row);
                rows.back().kind = kind;
                rows.back().value *= std::exp(0.06 * (of_specimen + std::sqrt(0.2) * normal()));
                with_own_names.push_back(rows.back());
                with_own_names.back().point += kind;
                if (!is_of_all) break;
            }
        }
        const KindSurface surface(rows, "granite");
        const KindSurface other(with_own_names, "granite");
        for (const KindCoordinates& at : six) {
            const auto found = surface.predict(at, uniaxial, 0);
            const double variance = std::pow(found->mean_deviation, 2) - 0.03 * 0.03;
            off += std::pow(std::log(found->value) - exact.log_of("uniaxial", at, 0), 2) / variance;
            together += variance;
            apart += std::pow(other.predict(at, uniaxial, 0)->mean_deviation, 2) - 0.03 * 0.03;
        }
    }
    EXPECT_NEAR(std::sqrt(off / 360), 1, 0.1);
    EXPECT_GT(std::sqrt(together / apart), 1.09);
}

// 95 % intervals of the mean of another rock, where four rocks tell how far rocks differ.
TEST(KindSurface, KnowsMeansOfRocksByTheirNumber) {
    const SyntheticKind planted;
    const KindCoordinates at{1, 1, 5, 0.77, 0.45, 0.7, 80, 0, 0};
    const double mean = planted.log_of("uniaxial", at, 0);
    int within = 0, within_normal = 0;
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        test::Normal normal(seed);
        std::vector<KindRow> rows = planted.rows(20, seed);
        std::erase_if(rows, [](const KindRow& row) { return row.property != "uniaxial"; });
        for (const char* rock : {"a", "b", "c", "d"}) {
            rows.push_back({"granite", rock, true, at, 0, "uniaxial", std::exp(mean + 0.15 * normal()), 1e6});
        }
        const KindSurface surface(rows, "granite");
        const auto found = surface.predict(at, uniaxial, 0);
        const double off = std::abs(mean + 0.15 * normal() - std::log(found->value)) / found->mean_deviation;
        within += off < student_t_95(surface.model(uniaxial, 0)->freedom_of_mean(surface.factors(at, 0))) ? 1 : 0;
        within_normal += off < deviations_of_95_percent ? 1 : 0;
    }
    EXPECT_NEAR(within / 400.0, 0.95, 0.025);
    EXPECT_LT(within_normal / 400.0, 0.91);
}

TEST(KindSurface, NamesItsSpecimens) {
    std::string text;
    for (const char* name : {"uniaxial", "direct_tension", "toughness", "brazilian"}) {
        text += fmt::format("{}: \"{}\"\n", name, KindSurface::specimen_of(property_named(name)));
    }
    test::expect_golden(text);
}

TEST(KindSurface, HasTheScatterOfRocksOffIt) {
    const SyntheticKind planted;
    std::vector<KindRow> rows = planted.rows(70);
    const std::vector<KindRow> others = planted.rows(40, 5);
    for (std::size_t i = 0; i < others.size(); ++i) {
        KindRow rock = others[i];
        rock.is_rock = true;
        rock.specimens = 16;
        rock.value = std::exp(planted.log_of(rock.property, rock.at, rock.confining_pressure) + (i / 5 % 2 == 0 ? 0.2 : -0.2));
        rows.push_back(rock);
    }
    EXPECT_NEAR(std::sqrt(KindSurface(rows, "granite").model(uniaxial, 0)->rock_variance), 0.2, 0.03);
}

TEST(KindSurface, HoldsWithinItsDesignAlone) {
    const KindSurface surface(SyntheticKind{}.rows(70), "granite");
    KindCoordinates at{10e6, 0.004, 5, 0.77, 0.45, 0.7, 80, 0, 0};
    EXPECT_TRUE(surface.holds(at));
    EXPECT_TRUE(surface.holds(at, 50e6));
    EXPECT_FALSE(surface.holds(at, 150e6));
    EXPECT_FALSE(surface.predict(at, first_peak, 150e6));
    EXPECT_NEAR(surface.predict(at, uniaxial, 0)->value, 1e7 * std::exp(2.9), 1e7 * std::exp(2.9) * 0.06);
    EXPECT_NEAR(surface.predict(at, toughness, 0)->value, 1e7 * std::sqrt(0.004) * std::exp(-0.8 + 0.5 * std::log(0.7 / 0.71)),
                3e4);
    EXPECT_NEAR(KindSurface::log_unit(uniaxial, at), std::log(1e7), 1e-12);
    at.contact_strain *= 2;
    EXPECT_NEAR(KindSurface::log_unit(property_named("crack_initiation"), at), std::log(1e7) - 0.24 * std::log(2), 1e-12);
    at.bridging_strength = 0.5;
    EXPECT_FALSE(surface.holds(at));  // no bridge has no energy
    at.bridging_energy = 8;
    EXPECT_TRUE(surface.holds(at));
    EXPECT_GT(surface.least().bridging_energy, 2.9);
    at.cohesion = 20;
    test::expect_golden(surface.beyond(at));
    EXPECT_FALSE(surface.predict(at, uniaxial, 0));
}

TEST(KindTable, IsOfMaterialsOfItsFabricAlone) {
    const test::KindFolder folder(granite_and_gabbro({}));
    Material rock = read_material("granite-crystals");
    const auto surface = KindSurface::of(rock);
    ASSERT_TRUE(surface);
    EXPECT_EQ(surface->kind(), "granite");
    const KindCoordinates at = kind_coordinates(rock);
    EXPECT_NEAR(at.cohesion, 4.76, 1e-9);
    EXPECT_NEAR(at.process_zone, 1.16, 1e-9);
    EXPECT_NEAR(at.mode_ii_fracture_energy, 47, 1e-9);
    EXPECT_NEAR(surface->predict(rock, uniaxial, 0)->value / at.tensile_strength,
                std::exp(SyntheticKind{}.log_of("uniaxial", at, 0)), 1.5);
    std::string reasons;
    const auto add_reason = [&](const char* what, const std::string& name, const std::function<void(Material&)>& change) {
        Material other = read_material(name);
        change(other);
        std::string why;
        EXPECT_FALSE(KindSurface::of(other, &why)) << what;
        reasons += fmt::format("{}: {}\n", what, why);
    };
    const std::string granite = "granite-crystals";
    add_reason("strong crystals", granite, [](Material& m) { m.fabric.within.fracture_energy = 4; });
    add_reason("bridges at boundaries alone", granite,
               [](Material& m) { m.fabric.within.bridging_strength = m.fabric.within.bridging_energy = 0; });
    rock.ratios.bridging_strength = rock.ratios.bridging_energy = 0;
    EXPECT_TRUE(KindSurface::of(rock));
    add_reason("no wear", granite, [](Material& m) { m.contact.wear_slip = 0; });
    add_reason("strong open contacts", granite, [&](Material& m) { m.contact.open_shear_strength = 2 * at.tensile_strength; });
    add_reason("no grain size", granite, [](Material& m) { m.grains.grain_size.reset(); });
    const auto with_rough_platens = [](Material& m) { m.platen_friction_angle = 10 * std::numbers::pi / 180; };
    add_reason("rough platens", granite, with_rough_platens);
    // The kind that it names, not the nearest.
    add_reason("rough platens of a gabbro", granite, [&](Material& m) { with_rough_platens(m), m.kind = "gabbro"; });
    add_reason("unknown kind", granite, [&](Material& m) { with_rough_platens(m), m.kind = "amphibolite"; });
    add_reason("no crystals", "augig-granite", [](Material&) {});
    test::expect_golden(reasons);
}

TEST(KindTable, RefusesWrongRows) {
    const test::KindFolder folder(granite_and_gabbro({}));
    const std::string text = text_of_file(folder.table());
    test::GoldenRefusals refused;
    const auto add = [&](const std::string& what, const std::string& row) {
        std::ofstream(folder.table()) << text << row << '\n';
        refused.add<InputError>(what, [] { (void)KindSurface::of(read_material("granite-crystals")); });
    };
    add("negative cohesion", "granite\ta\t0\t-5\t44\t26\t0.7\t80\t0\t0\t0\tuniaxial\t18\t1");
    add("unknown property", "granite\ta\t0\t5\t44\t26\t0.7\t80\t0\t0\t0\tstrength\t18\t1");
    add("uniaxial test under pressure", "granite\ta\t0\t5\t44\t26\t0.7\t80\t0\t0\t2\tuniaxial\t18\t1");
    add("bridges without energy", "granite\ta\t0\t5\t44\t26\t0.7\t80\t0.4\t0\t0\tuniaxial\t18\t1");
}

TEST(KindTable, HasTermsAndRocks) {
    std::vector<KindRow> rows = SyntheticKind{}.rows(70);
    const KindSurface surface(rows, "granite");
    const std::string terms = test::written(write_kind_terms, surface, TableFormat::tsv);
    EXPECT_NE(terms.find("\nuniaxial\tln(cohesion/5)^2\t"), std::string::npos);
    EXPECT_NE(terms.find("\nfirst_peak\tln(cohesion/5) ln(confining_pressure/1.5)\t"), std::string::npos);
    rows.resize(2);
    rows[0].is_rock = rows[1].is_rock = true;
    rows[0].point = "Augig granite";
    rows[0].value = 1.1 * surface.predict(rows[0].at, uniaxial, 0)->value;
    rows[0].specimens = 9;
    rows[1].at.cohesion = 30;
    const std::string rocks = test::written(write_kind_rocks, surface, rows, TableFormat::tsv);
    EXPECT_EQ(test::field(rocks, "rock", 0), "Augig granite");
    EXPECT_NEAR(test::number_in(rocks, "off_percent", 0), 100 / 1.1 - 100, 1e-4);
    EXPECT_LT(test::number_in(rocks, "low_percent", 0), 100 / 1.1 - 103);
    EXPECT_EQ(test::field(rocks, "predicted", 1), "");
}

}  // namespace
}  // namespace graincrack
