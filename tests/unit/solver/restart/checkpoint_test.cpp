// A checkpoint goes on as the test that it was.
#include "solver/restart/checkpoint.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/golden.hpp"

namespace graincrack::test {
namespace {

TEST(Checkpoint, ResumesWithTheSameContactParametersOnly) {
    RunHeader before;
    before.stop_reason = "checkpoint";
    EXPECT_NO_THROW(require_same_test("run.checkpoint", before, before));
    Refusals refused;
    for (const ContactParameter& row : all_contact_parameters()) {
        RunHeader now = before;
        now.contact.*row.value += 1;
        refused.add<InputError>(std::string(row.quantity.name), [&] { require_same_test("run.checkpoint", before, now); });
    }
    expect_golden(refused.text());
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
    Refusals refused;
    refused.add<InputError>("another rate tolerance", [&] { require_same_test("run.checkpoint", before, now); });
    expect_golden(refused.text());
}

}  // namespace
}  // namespace graincrack::test
