#include "app/services/log/sequencer.h"

#include <algorithm>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

RawEvent eventAt(int milliseconds) {
    RawEvent event;
    event.received = Time(std::chrono::milliseconds(milliseconds));
    event.cdr = std::make_shared<const std::vector<std::byte>>();
    return event;
}

TEST(Sequencer, NumbersOnFromTheEarlierSession) {
    std::vector<std::uint64_t> seen;
    Sequencer sequencer(41, [&](const RawEvent& event) { seen.push_back(event.sequence); });
    for (int i = 1; i <= 3; ++i) sequencer.push(eventAt(i));
    sequencer.drain();
    EXPECT_EQ(seen, (std::vector<std::uint64_t>{42, 43, 44}));
}

TEST(Sequencer, TimeNeverRunsBackwards) {
    std::vector<Time> seen;
    Sequencer sequencer(0, [&](const RawEvent& event) { seen.push_back(event.received); });
    for (const int at : {50, 10, 70, 60}) {
        sequencer.push(eventAt(at));
        sequencer.drain();
    }
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.back(), Time(std::chrono::milliseconds(70)));
}

TEST(Sequencer, LosesNothingOfManyThreadsAndHandsOverTheRestWhenItEnds) {
    constexpr int Threads = 4, Each = 5'000;
    std::vector<std::uint64_t> seen;
    {
        Sequencer sequencer(0, [&](const RawEvent& event) { seen.push_back(event.sequence); });
        std::vector<std::jthread> pushing;
        for (int t = 0; t < Threads; ++t) {
            pushing.emplace_back([&] {
                for (int i = 0; i < Each; ++i) sequencer.push(eventAt(i + 1));
            });
        }
    }
    ASSERT_EQ(seen.size(), std::size_t{Threads * Each});
    for (std::size_t i = 0; i < seen.size(); ++i) ASSERT_EQ(seen[i], i + 1);
}

TEST(Sequencer, TheSinkMayPush) {
    int handled = 0;
    Sequencer* self = nullptr;
    Sequencer sequencer(0, [&](const RawEvent&) {
        if (++handled == 1) self->push(eventAt(2));
    });
    self = &sequencer;
    sequencer.push(eventAt(1));
    sequencer.drain();
    sequencer.drain();
    EXPECT_EQ(handled, 2);
}

}  // namespace
}  // namespace leitstand::test
