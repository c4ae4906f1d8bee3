// A checkpoint goes on as the test that it was.
#include "solver/restart/checkpoint.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"

namespace graincrack {
namespace {

TEST(Checkpoint, GoesOnWithTheSameContactParametersOnly) {
    RunHeader before;
    before.stop_reason = "checkpoint";
    EXPECT_NO_THROW(require_same_test("run.checkpoint", before, before));
    for (const ContactParameter& row : all_contact_parameters()) {
        RunHeader now = before;
        now.contact.*row.value += 1;
        test::expect_one_line<InputError>([&] { require_same_test("run.checkpoint", before, now); },
                                          {"run.checkpoint: " + row.option() + " was 0, not 1"});
    }
}

}  // namespace
}  // namespace graincrack
