// What a page of `view` holds of a run with known answers.
#include "post/report/view_page.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "post/report/packed_array.hpp"
#include "share/file/probe_file.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

/// The numbers of `packed`, read back as the page does.
std::vector<std::int32_t> unpacked(const std::string& letters) {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned char> bytes;
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < letters.size() && letters[i] != '='; ++i) {
        word = (word << 6U) | static_cast<std::uint32_t>(alphabet.find(letters[i]));
        if (i % 4 != 0) bytes.push_back(static_cast<unsigned char>(word >> (6 - 2 * (i % 4))));
    }
    std::vector<unsigned char> planes(std::size_t{1} << 22U);
    uLongf size = planes.size();
    EXPECT_EQ(uncompress(planes.data(), &size, bytes.data(), bytes.size()), Z_OK);
    const std::size_t n = size / 4;
    std::vector<std::int32_t> values;
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
        std::uint32_t code = 0;
        for (std::size_t plane = 0; plane < 4; ++plane) code |= std::uint32_t{planes[plane * n + i]} << (8 * plane);
        sum += (code >> 1U) ^ (0U - (code & 1U));
        values.push_back(static_cast<std::int32_t>(sum));
    }
    return values;
}

TEST(PackedArray, ComesBackAsItWas) {
    const std::vector<std::int32_t> values{7, 0, -1, 65535, 2147483647, -2147483647 - 1, 5, 5};
    EXPECT_EQ(unpacked(packed(values)), values);
    EXPECT_TRUE(unpacked(packed({})).empty());
    std::vector<std::int32_t> ascending(60000);
    for (std::size_t i = 0; i < ascending.size(); ++i) ascending[i] = static_cast<std::int32_t>(i);
    EXPECT_LT(packed(ascending).size(), 1000U);
}

TEST(QuantisedArray, IsOffByHalfAStepOfItsRangeAtMost) {
    std::mt19937_64 random(1);
    for (const double scale : {1e-9, 1.0, 3e8}) {
        std::vector<double> values(1000);
        for (double& value : values) value = scale * (static_cast<double>(random() % 100000) - 3e4);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        const QuantisedArray array = quantised(values);
        EXPECT_DOUBLE_EQ(array.step, (*high - *low) / 65535);
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_LE(std::abs(array.low + array.step * array.steps[i] - values[i]), 0.5001 * array.step);
        }
    }
    EXPECT_EQ(quantised({2, 2}).step, 0);
    EXPECT_EQ(quantised({2, 2}).low, 2);
    EXPECT_EQ(quantised({1, NAN, 3}).steps, (std::vector<std::int32_t>{0, 0, 65535}));
    EXPECT_EQ(quantised({-1e308, 1e308}).steps, (std::vector<std::int32_t>{0, 65535}));
}

TEST(ChosenFrames, HaveTheFirstTheKeptAndTheLast) {
    EXPECT_EQ(evenly_chosen(1, 3, 0), (std::vector<std::size_t>{0}));
    EXPECT_EQ(evenly_chosen(4, 4, 2), (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(evenly_chosen(11, 4, 7), (std::vector<std::size_t>{0, 5, 7, 10}));
    EXPECT_EQ(evenly_chosen(100, 25, 33).size(), 25U);
}

class ViewPage : public test::RunFolder {
protected:
    /// The page of the run, and what it holds.
    std::string page(const ViewOptions& options = {}) { return make_view({run("run.h5", recipe_)}, options, Verbosity::quiet); }
    static nlohmann::json runs_of(const std::string& page) {
        const std::string begin = "id=\"runs\">";
        const std::size_t from = page.find(begin) + begin.size();
        return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
    }
    test::Recipe recipe_;
};

TEST_F(ViewPage, HoldsTheSpecimenTheFramesAndTheCracksOfEach) {
    const nlohmann::json run = runs_of(page()).at(0);
    const Specimen& s = recipe_.specimen;
    const std::vector<Crack> cracks = test::synthetic_cracks(s);
    const auto count = [](const nlohmann::json& array) { return unpacked(array.at("data")).size(); };
    EXPECT_EQ(count(run["specimen"]["x"]), s.n_nodes());
    EXPECT_EQ(count(run["specimen"]["elements"]), 3 * s.n_elements());
    EXPECT_EQ(count(run["specimen"]["contacts"]), 4 * s.n_contacts());
    EXPECT_EQ(unpacked(run["specimen"]["contacts"]["data"])[s.n_contacts() + 2], s.contact_nodes[2][1]);
    EXPECT_EQ(count(run["cracks"]["contact"]), cracks.size());
    ASSERT_EQ(run["frames"].size(), 3U);
    const std::vector<double> times{0, 1, 1.25};
    for (std::size_t i = 0; i < times.size(); ++i) {
        const nlohmann::json& frame = run["frames"][i];
        const auto present =
            std::count_if(cracks.begin(), cracks.end(), [&](const Crack& crack) { return crack.time <= times[i]; });
        EXPECT_EQ(frame["cracks"], present);
        EXPECT_EQ(count(frame["u"]), s.n_nodes());
        EXPECT_EQ(count(frame["xx"]), s.n_elements());
        EXPECT_EQ(count(frame["opening"]), 2 * s.n_contacts());
    }
    const auto shear = unpacked(run["cracks"]["shear"]["data"]);
    EXPECT_EQ(std::count(shear.begin(), shear.end(), 1),
              std::count_if(cracks.begin(), cracks.end(), [](const Crack& crack) { return crack.mode == CrackMode::shear; }));
    EXPECT_NEAR(run["curve"]["marks"].back()["y"].get<double>(), run["frames"][1]["y"].get<double>(), 1e-9);  // of the peak
}

TEST_F(ViewPage, HasForceOverDisplacementOfTheBoundaryOfAProgramThatWorksMost) {
    recipe_.test = "program";
    History history = test::synthetic_history(recipe_);
    for (const auto column : {HistoryColumn::axial_stress, HistoryColumn::force_top, HistoryColumn::force_bottom}) {
        history[column].assign(history.size(), 0);
    }
    std::vector<double> way(history.size()), nothing(history.size());
    for (std::size_t row = 0; row < way.size(); ++row) way[row] = 1e-6 * static_cast<double>(row);
    const std::vector<ProbeColumn> columns{{"displacement_y", Dimension::length, ""}, {"force_y", Dimension::force, ""}};
    RunWriter writer(H5Output(folder_.file("program.h5"), "run"), recipe_.specimen, test::synthetic_header(recipe_));
    writer.append_history(history);
    writer.add_frame(test::synthetic_frame(recipe_.specimen, 1, 0.005, 0), FrameRole::kept);
    append_probes(writer.file(), {{"base", columns, {nothing, way}}, {"push", columns, {way, way}}}, 0);
    writer.finish(test::synthetic_header(recipe_), {}, {});
    const nlohmann::json curve = runs_of(make_view({folder_.file("program.h5")}, {}, Verbosity::quiet))[0]["curve"];
    test::expect_golden(curve["across"]);
    EXPECT_NEAR(curve["x"]["step"].get<double>(), 1e3 * way.back() / 65535, 1e-12);
    EXPECT_TRUE(curve["marks"].empty());
}

TEST_F(ViewPage, KeepsTheNameOfAMaterialAsText) {
    recipe_.material = "</script><script>alert(1)</script><!-- \xff \xe2\x80\xae & \"";
    const std::string text = page();
    EXPECT_EQ(text.find("<script>alert"), std::string::npos);
    EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos);
    EXPECT_NE(runs_of(text)[0]["title"].get<std::string>().find("</script><script>alert(1)</script><!-- "), std::string::npos);
}

}  // namespace
}  // namespace graincrack
