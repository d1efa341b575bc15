#include <deque>

#include <gmock/gmock.h>

#include "core/event/station_samples.h"
#include "core/robot/control/grant_book.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

using Action = GrantSample::Action;

GrantBook book(const std::string& station, std::uint8_t process, std::int64_t began = 0,
               std::vector<HeldGrant> held = {}) {
    return GrantBook({station, fmt::format("Title of {}", station), std::move(held)}, sender(process),
                     at(began));
}

/// Lets @p books talk to each other without loss from @p from to @p until [ms].
void talk(std::initializer_list<std::pair<GrantBook*, std::uint8_t>> books, std::int64_t from,
          std::int64_t until) {
    for (std::int64_t now = from; now <= until; now += 50) {
        for (const auto& [speaker, process] : books) {
            for (const GrantSample& reported : speaker->due(at(now), wallAt(now))) {
                for (const auto& [listener, other] : books) {
                    if (listener != speaker) listener->receive(reported, sender(process), at(now));
                }
            }
        }
    }
}

TEST(GrantBook, NobodysGrantIsTakenAfterThreeSecondsOfListening) {
    GrantBook a = book("a", 1);
    EXPECT_FALSE(a.view(Drive, at(0)).asked);
    a.requestGrant(Drive);
    EXPECT_TRUE(a.view(Drive, at(0)).asked);
    EXPECT_TRUE(a.due(at(2'950), wallAt(2'950)).empty());
    EXPECT_FALSE(a.mayAct(Drive, at(2'950)));
    const auto reported = a.due(at(3'000), wallAt(3'000));
    ASSERT_EQ(reported.size(), 1U);
    EXPECT_EQ(reported[0].action, Action::Hold);
    EXPECT_EQ(reported[0].station, "a");
    EXPECT_EQ(reported[0].title, "Title of a");
    EXPECT_EQ(reported[0].robot, "kurt3d");
    EXPECT_EQ(reported[0].stamp, wallAt(3'000));
    EXPECT_GT(reported[0].term, 0U);
    EXPECT_TRUE(a.mayAct(Drive, at(3'000)));
    EXPECT_EQ(a.view(Drive, at(3'000)).holder, "a");
    EXPECT_EQ(a.held(), (std::vector<HeldGrant>{{Drive, reported[0].term}}));
}

TEST(GrantBook, TheHeartbeatComesOnceASecond) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}});
    int beats = 0;
    for (std::int64_t now = 0; now < 10'000; now += 50) {
        for (const GrantSample& reported : a.due(at(now), wallAt(now))) {
            beats += reported.action == Action::Hold ? 1 : 0;
            EXPECT_EQ(reported.term, 5U);
        }
    }
    EXPECT_EQ(beats, 10);
}

TEST(GrantBook, WhoDidNotSpeakForThreeSecondsMayNotAct) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}});
    EXPECT_FALSE(a.mayAct(Drive, at(0))) << "nobody has heard of it yet";
    static_cast<void>(a.due(at(0), wallAt(0)));
    EXPECT_TRUE(a.mayAct(Drive, at(2'999)));
    EXPECT_FALSE(a.mayAct(Drive, at(3'000))) << "the computer was suspended";
}

TEST(GrantBook, ASecondStationIsRefusedUntilTheHolderIsSilentForThreeSeconds) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 0, 10'000);
    EXPECT_TRUE(a.mayAct(Drive, at(10'000)));
    EXPECT_FALSE(b.mayAct(Drive, at(10'000)));
    EXPECT_EQ(b.view(Drive, at(10'000)).holder, "a");
    EXPECT_EQ(a.view(Drive, at(10'000)).requestedBy, "b");
    EXPECT_EQ(a.view(Drive, at(10'000)).requestedByTitle, "Title of b");
    // From here on, a is silent; its last heartbeat was at 10 s.
    talk({{&b, 2}}, 10'050, 12'950);
    EXPECT_FALSE(b.view(Drive, at(12'950)).mine);
    talk({{&b, 2}}, 13'000, 13'000);
    EXPECT_TRUE(b.mayAct(Drive, at(13'000)));
    // a speaks again: it finds that b has it, and says so.
    talk({{&a, 1}, {&b, 2}}, 13'050, 15'000);
    EXPECT_FALSE(a.view(Drive, at(15'000)).mine);
    EXPECT_EQ(a.view(Drive, at(15'000)).lostTo, "b");
    EXPECT_TRUE(b.mayAct(Drive, at(15'000)));
}

TEST(GrantBook, AStationThatJoinsTheNetworkAgainGoesOnHoldingAndAsking) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 0, 1'000);
    a.rejoined(sender(7));
    EXPECT_TRUE(a.mayAct(Drive, at(1'050)));
    EXPECT_EQ(a.held(), (std::vector<HeldGrant>{{Drive, 5}})) << "under the same term";
    talk({{&a, 7}, {&b, 2}}, 1'050, 10'000);
    EXPECT_TRUE(a.mayAct(Drive, at(10'000)));
    EXPECT_EQ(b.view(Drive, at(10'000)).holder, "a");
    EXPECT_EQ(b.view(Drive, at(10'000)).lostTo, "");
    EXPECT_EQ(a.view(Drive, at(10'000)).requestedBy, "b");
    b.rejoined(sender(8));
    talk({{&a, 7}, {&b, 8}}, 10'050, 11'500);
    a.answerRequest(Drive, true, at(11'500));
    talk({{&a, 7}, {&b, 8}}, 11'550, 11'700);
    EXPECT_TRUE(b.mayAct(Drive, at(11'700)));
    EXPECT_EQ(a.view(Drive, at(11'700)).holder, "b");
    // What it says itself under its new identity is not another's.
    const auto own = b.due(at(13'000), wallAt(13'000));
    ASSERT_FALSE(own.empty());
    b.receive(own[0], sender(8), at(13'000));
    EXPECT_TRUE(b.view(Drive, at(13'000)).mine);
}

TEST(GrantBook, TheHolderConsentsOrRefuses) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 0, 1'000);
    a.answerRequest(Drive, false, at(1'000));
    talk({{&a, 1}, {&b, 2}}, 1'050, 5'000);
    EXPECT_EQ(b.view(Drive, at(5'000)).refusedBy, "a");
    EXPECT_FALSE(b.view(Drive, at(5'000)).asked);
    EXPECT_EQ(a.view(Drive, at(5'000)).requestedBy, "");
    b.requestGrant(Drive);
    EXPECT_EQ(b.view(Drive, at(5'000)).refusedBy, "");
    talk({{&a, 1}, {&b, 2}}, 5'050, 6'000);
    a.answerRequest(Drive, true, at(6'000));
    EXPECT_FALSE(a.view(Drive, at(6'000)).mine) << "before anybody else has it";
    talk({{&a, 1}, {&b, 2}}, 6'050, 6'100);
    EXPECT_TRUE(b.mayAct(Drive, at(6'100)));
    EXPECT_EQ(a.view(Drive, at(6'200)).holder, "b");
}

TEST(GrantBook, AConsentIsForOneOnly) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2), c = book("c", 3);
    c.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}, {&c, 3}}, 0, 500);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}, {&c, 3}}, 550, 2'000);
    EXPECT_EQ(a.view(Drive, at(2'000)).requestedBy, "c") << "who asked first";
    a.answerRequest(Drive, true, at(2'000));
    talk({{&a, 1}, {&b, 2}, {&c, 3}}, 2'050, 9'000);
    EXPECT_TRUE(c.mayAct(Drive, at(9'000)));
    EXPECT_FALSE(b.view(Drive, at(9'000)).mine);
    EXPECT_EQ(c.view(Drive, at(9'000)).requestedBy, "b");
    // Who goes while somebody waits, gives it to him.
    c.leave(at(9'000));
    talk({{&a, 1}, {&b, 2}, {&c, 3}}, 9'050, 9'200);
    EXPECT_TRUE(b.mayAct(Drive, at(9'200)));
}

TEST(GrantBook, WhatIsReleasedIsFreeAtOnce) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    talk({{&a, 1}, {&b, 2}}, 0, 1'000);
    a.release(Drive, at(1'000));
    talk({{&a, 1}, {&b, 2}}, 1'050, 1'100);
    EXPECT_EQ(b.view(Drive, at(1'100)).holder, "");
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 1'150, 1'200);
    EXPECT_TRUE(b.mayAct(Drive, at(1'200)));
}

TEST(GrantBook, WhoAsksNoLongerTakesNothing) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 0, 1'000);
    b.release(Drive, at(1'000));
    talk({{&a, 1}, {&b, 2}}, 1'050, 5'000);
    EXPECT_EQ(a.view(Drive, at(5'000)).requestedBy, "") << "a question that is not repeated lapses";
    talk({{&b, 2}}, 5'050, 20'000);
    EXPECT_FALSE(b.view(Drive, at(20'000)).mine);
    EXPECT_TRUE(b.view(Drive, at(20'000)).silent);
}

TEST(GrantBook, ARestartedStationHasItsOwnBackAtOnce) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 0, 1'000);
    GrantBook again = book("a", 3, 2'000, a.held());
    talk({{&again, 3}, {&b, 2}}, 2'000, 2'050);
    EXPECT_TRUE(again.mayAct(Drive, at(2'050)));
    talk({{&again, 3}, {&b, 2}}, 2'100, 20'000);
    EXPECT_TRUE(again.mayAct(Drive, at(20'000)));
    EXPECT_FALSE(b.view(Drive, at(20'000)).mine);
}

TEST(GrantBook, ARestartedStationThatForgotHasItBackAtOnceToo) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), again = book("a", 3);
    for (const GrantSample& reported : a.due(at(0), wallAt(0))) again.receive(reported, sender(1), at(0));
    again.requestGrant(Drive);
    static_cast<void>(again.due(at(50), wallAt(50)));
    EXPECT_TRUE(again.mayAct(Drive, at(50)));
}

TEST(GrantBook, WhoComesBackTooLateFindsItTaken) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 0, 1'000);
    const auto remembered = a.held();
    talk({{&b, 2}}, 1'050, 8'000);
    ASSERT_TRUE(b.mayAct(Drive, at(8'000)));
    GrantBook again = book("a", 3, 8'000, remembered);
    talk({{&again, 3}, {&b, 2}}, 8'000, 10'000);
    EXPECT_FALSE(again.view(Drive, at(10'000)).mine);
    EXPECT_TRUE(b.mayAct(Drive, at(10'000)));
}

TEST(GrantBook, OfTwoThatTakeItInTheSameMomentBothAgreeOnOne) {
    for (const bool swapped : {false, true}) {
        GrantBook a = book("a", swapped ? 2 : 1), b = book("b", swapped ? 1 : 2);
        a.requestGrant(Drive);
        b.requestGrant(Drive);
        const auto saidA = a.due(at(3'000), wallAt(3'000)), saidB = b.due(at(3'000), wallAt(3'000));
        ASSERT_TRUE(a.view(Drive, at(3'000)).mine && b.view(Drive, at(3'000)).mine);
        for (const GrantSample& reported : saidB) a.receive(reported, sender(swapped ? 1 : 2), at(3'020));
        for (const GrantSample& reported : saidA) b.receive(reported, sender(swapped ? 2 : 1), at(3'020));
        EXPECT_TRUE(a.view(Drive, at(3'020)).mine) << "of equal terms the smaller identity";
        EXPECT_FALSE(b.view(Drive, at(3'020)).mine);
        const auto yielded = b.due(at(3'050), wallAt(3'050));
        ASSERT_EQ(yielded.size(), 1U);
        EXPECT_EQ(yielded[0].action, Action::Consent) << "so that robots follow";
        EXPECT_EQ(yielded[0].other, "a");
    }
}

TEST(GrantBook, AHigherTermIsRightWhateverTheIdentity) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}});
    static_cast<void>(a.due(at(0), wallAt(0)));
    a.receive(grantSaying("z", Action::Hold, 6), sender(9), at(100));
    EXPECT_FALSE(a.view(Drive, at(100)).mine);
    GrantBook other = book("a", 1, 0, {{Drive, 7}});
    other.receive(grantSaying("z", Action::Hold, 6), sender(9), at(100));
    EXPECT_TRUE(other.view(Drive, at(100)).mine);
    const auto reported = other.due(at(100), wallAt(100));
    ASSERT_EQ(reported.size(), 1U) << "z hears at once that it is wrong";
}

TEST(GrantBook, TwoProcessesOfOneIdentityAgreeOnOne) {
    GrantBook first = book("a", 1, 0, {{Drive, 5}}), second = book("a", 2, 0, {{Drive, 5}});
    talk({{&first, 1}, {&second, 2}}, 0, 2'000);
    EXPECT_TRUE(first.view(Drive, at(2'000)).mine);
    EXPECT_FALSE(second.view(Drive, at(2'000)).mine);
}

TEST(GrantBook, AnswersOfOthersThanTheHolderCountForNothing) {
    GrantBook a = book("a", 1, 0, {{Drive, 5}}), b = book("b", 2);
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 0, 500);
    b.receive(grantSaying("a", Action::Consent, 5, "b"), sender(9), at(600));  // says that it is a
    b.receive(grantSaying("c", Action::Consent, 5, "b"), sender(9), at(600));
    b.receive(grantSaying("c", Action::Release, 5), sender(9), at(600));
    b.receive(grantSaying("c", Action::Refuse, 5, "b"), sender(9), at(600));
    static_cast<void>(b.due(at(650), wallAt(650)));
    EXPECT_FALSE(b.view(Drive, at(650)).mine);
    EXPECT_TRUE(b.view(Drive, at(650)).asked);
}

TEST(GrantBook, TheHighestTermOfAllIsNoLockForEver) {
    GrantBook a = book("a", 1), b = book("b", 2);
    const GrantSample absurd = grantSaying("x", Action::Hold, std::uint64_t{1} << 62U);
    a.receive(absurd, sender(9), at(0));
    b.receive(absurd, sender(9), at(0));
    b.requestGrant(Drive);
    talk({{&a, 1}, {&b, 2}}, 50, 4'000);
    EXPECT_TRUE(b.mayAct(Drive, at(4'000)));
    EXPECT_EQ(a.view(Drive, at(4'000)).holder, "b");
}

TEST(GrantBook, AFloodOfNamesTakesNoMoreThanItsShare) {
    GrantBook a = book("a", 1);
    for (int i = 0; i < 10'000; ++i) {
        GrantSample reported = grantSaying(fmt::format("x{}", i), Action::Hold, ~std::uint64_t{0});
        a.receive(reported, sender(2), at(i));
        reported.term = 3;
        reported.robot = fmt::format("robot{}", i);
        a.receive(reported, sender(2), at(i));
    }
    EXPECT_LE(a.known().size(), 256U);
    EXPECT_EQ(a.view(Drive, at(0)).holder, "") << "terms beyond reason are none";
}

}  // namespace
}  // namespace leitstand::test
