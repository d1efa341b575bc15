#include "core/robot/streams/request_book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;
using testing::SizeIs;

const SteadyTime Start{1000s};

TEST(RequestBook, ANewWishIsSaidThreeTimesAndThenEveryFiveSeconds) {
    RequestBook book;
    EXPECT_THAT(book.due(Start), IsEmpty());
    book.set("/k/left", {.rate = 5.0});
    std::vector<int> reported;
    for (int second = 0; second < 20; ++second) {
        if (!book.due(Start + std::chrono::seconds(second)).empty()) reported.push_back(second);
    }
    EXPECT_THAT(reported, testing::ElementsAre(0, 1, 2, 7, 12, 17));
    book.set("/k/left", {.rate = 5.0});
    EXPECT_THAT(book.due(Start + 18s), IsEmpty()) << "nothing new";
    book.set("/k/left", {.rate = 2.0});
    const auto due = book.due(Start + 18s);
    ASSERT_THAT(due, SizeIs(1));
    EXPECT_EQ(due.front().rate, 2.0);
}

TEST(RequestBook, AWishTakenBackIsSaidAndForgotten) {
    RequestBook book;
    book.set("/k/left", {.enabled = false});
    for (int i = 0; i < 10; ++i) (void)book.due(Start + i * 1s);
    book.set("/k/left", {});
    int reported = 0;
    for (int i = 10; i < 60; ++i) {
        for (const auto& command : book.due(Start + i * 1s)) {
            EXPECT_TRUE(command.enabled);
            ++reported;
        }
    }
    EXPECT_EQ(reported, 3);
}

TEST(RequestBook, AThinLinkGoesOverTheOperatorsWishesAndGivesThemBack) {
    RequestBook book;
    book.set("/k/left", {.rate = 10.0, .quality = 50});
    book.setThin({{"/k/left", {.rate = 5.0}}, {"/k/right", {.enabled = false}}});
    EXPECT_EQ(book.effective("/k/left"), (StreamRequest{.rate = 5.0, .quality = 50}));
    EXPECT_FALSE(book.effective("/k/right").enabled);
    EXPECT_TRUE(book.own("/k/right").isPlain());
    EXPECT_THAT(book.due(Start), SizeIs(2));
    book.setThin({});
    EXPECT_EQ(book.effective("/k/left"), (StreamRequest{.rate = 10.0, .quality = 50}));
    EXPECT_TRUE(book.effective("/k/right").isPlain());
    EXPECT_THAT(book.due(Start + 100ms), SizeIs(2)) << "at once, both";
}

TEST(RequestBook, ARobotThatIsBackIsToldAgainAtOnce) {
    RequestBook book;
    book.set("/k/left", {.rate = 5.0});
    book.set("/k/right", {});
    for (int i = 0; i < 10; ++i) (void)book.due(Start + i * 1s);
    EXPECT_THAT(book.due(Start + 9100ms), IsEmpty());
    book.returned();
    EXPECT_THAT(book.due(Start + 9200ms), SizeIs(1)) << "only what is wished";
}

}  // namespace
}  // namespace leitstand::test
