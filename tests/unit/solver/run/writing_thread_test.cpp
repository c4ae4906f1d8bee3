// The order of what is written, and who learns of errors.
#include "solver/run/writing_thread.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/synthetic_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {
namespace {

class WritingThreads : public testing::TestWithParam<bool> {
protected:
    TemporaryFolder folder_;
    WritingThread thread_{
        std::make_unique<RunWriter>(H5Output(folder_.file("run.h5"), "run"), Recipe{}.specimen, synthetic_header({})),
        GetParam()};
};

TEST_P(WritingThreads, DoTheirWorkInItsOrder) {
    std::string done;
    const std::thread::id caller = std::this_thread::get_id();
    for (const char name : {'a', 'b', 'c'}) {
        thread_.later([&, name](RunWriter& /*run*/) {
            done += name;
            EXPECT_EQ(std::this_thread::get_id() == caller, !GetParam());
        });
    }
    EXPECT_EQ(&thread_.when_done(), &thread_.when_done());
    EXPECT_TRUE(thread_.is_done());
    EXPECT_EQ(done, "abc");
}

TEST_P(WritingThreads, EndTheNextCallByTheirError) {
    const auto fail = [](RunWriter& /*run*/) { throw OutputError("disk.h5: is full"); };
    const auto write = [&] {
        thread_.later(fail);
        thread_.later([](RunWriter& /*run*/) { ADD_FAILURE() << "is not begun"; });
    };
    EXPECT_THROW(write(), OutputError);
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutOne, WritingThreads, testing::Bool());

}  // namespace
}  // namespace graincrack::test
