#include "post/measure/history.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using namespace std::chrono_literals;

TEST(HistoryFollow, WritesRowsOfARunInWorkOnceEach) {
    const test::TemporaryFolder folder;
    const std::string name = folder.file("run.h5");
    const test::Recipe recipe;
    const History whole = test::synthetic_history(recipe);
    History part;
    RunWriter writer(H5Output(name, "run"), recipe.specimen, test::synthetic_header(recipe));
    const auto grow = [&](std::size_t rows) {
        for (std::size_t c = 0; c < whole.columns.size(); ++c) {
            part.columns[c].assign(whole.columns[c].begin(), whole.columns[c].begin() + static_cast<std::ptrdiff_t>(rows));
        }
        writer.append_history(part);
    };
    grow(5);
    std::ostringstream out;
    std::thread follower([&] { follow_history(out, name, TableFormat::tsv, 5ms); });
    for (const std::size_t rows : {20U, 60U, 100U}) {
        std::this_thread::sleep_for(20ms);
        grow(rows);
    }
    grow(whole.size());
    writer.finish(test::synthetic_header(recipe), {}, Provenance{});
    follower.join();
    EXPECT_EQ(out.str(), test::written(write_history, RunReader(name), TableFormat::tsv));
    EXPECT_EQ(test::parse_tsv(out.str()).size(), whole.size() + 1);
}

TEST(HistoryFollow, WritesAFinishedRunAtOnce) {
    const test::TemporaryFolder folder;
    test::write_run(folder.file("run.h5"), {});
    const std::string followed = test::written(follow_history, folder.file("run.h5"), TableFormat::tsv, 1ms);
    EXPECT_EQ(test::parse_tsv(followed).size(), 112U);
}

TEST(HistoryFollow, RefusesMissingAndAbandonedRuns) {
    const test::TemporaryFolder folder;
    test::GoldenRefusals refused;
    const auto add = [&](const std::string& name) {
        refused.add<InputError>(name, [&] { test::written(follow_history, folder.file(name), TableFormat::tsv, 5ms); });
    };
    add("none.h5");
    std::ofstream(folder.file("dead.h5.part")) << "unfinished";
    std::thread killer([&] {
        std::this_thread::sleep_for(30ms);
        std::filesystem::remove(folder.file("dead.h5.part"));
    });
    add("dead.h5");
    killer.join();
}

}  // namespace
}  // namespace graincrack
