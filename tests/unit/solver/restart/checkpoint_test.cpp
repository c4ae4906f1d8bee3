// A checkpoint goes on as the test that it was.
#include "solver/restart/checkpoint.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"

namespace graincrack {
namespace {

TEST(Checkpoint, ResumesWithTheSameContactParametersOnly) {
    RunHeader before;
    before.stop_reason = "checkpoint";
    EXPECT_NO_THROW(require_same_test("run.checkpoint", before, before));
    for (const ContactParameter& row : all_contact_parameters()) {
        RunHeader now = before;
        now.contact.*row.value += 1;
        test::expect_one_line<InputError>([&] { require_same_test("run.checkpoint", before, now); },
                                          {"run.checkpoint: " + row.option() + " was 0", ", not "});
    }
}

TEST(Checkpoint, ResumesWithTheSameSettingsButForTheEnd) {
    RunHeader before;
    before.stop_reason = "checkpoint";
    before.request = {{"rate_tolerance", 3e-3, Dimension::one, SettingGroup::rate},
                      {"frames", 20.0},
                      {"peak_drop", 0.3, Dimension::one, SettingGroup::end}};
    RunHeader now = before;
    now.request[1].value = 5.0;
    now.request[2].value = 0.5;
    EXPECT_NO_THROW(require_same_test("run.checkpoint", before, now));
    now.request[0].value = 6e-3;
    test::expect_one_line<InputError>([&] { require_same_test("run.checkpoint", before, now); },
                                      {"run.checkpoint: --rate-tolerance was 0.003, not 0.006; a test resumes only"});
}

}  // namespace
}  // namespace graincrack
