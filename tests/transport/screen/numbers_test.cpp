#include "tests/transport/screen/screen_fixture.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Why = ScreenDrop::Kind;

TEST_F(ScreenTest, TheFirstHeartbeatMayBeAnywhereAndNoneJumpsFromThere) {
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1'000'000'000, 1'000'000'100, 77)));
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1'000'000'050, 1'000'000'150, 78)));
    for (int i = 0; i < 12; ++i) {
        EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, 1, Huge, 100)));
        EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, Huge, Huge, 100)));
    }
    EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, 1, 1'500'000'000, 79)));
    EXPECT_EQ(dropped(Why::Numbers), 25U);
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1'000'000'060, 1'000'000'160, 79)));
}

TEST_F(ScreenTest, NoFirstNumberIsOneThatNoWriterReaches) {
    EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, 1, Huge)));
    EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, Huge, Huge)));
    EXPECT_FALSE(takes(Packet().data(OdometryWriter, Huge, Bytes(8))));
    EXPECT_FALSE(takes(Packet().gap(OdometryWriter, Huge, Huge + 1)));
    EXPECT_FALSE(takes(Packet().acknowledge(OdometryReader, 0x203, Huge, 1)));
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 5)));
}

TEST_F(ScreenTest, SmallJumpsDoNotAddUp) {
    std::int64_t number = 1;
    ASSERT_TRUE(takes(Packet().data(OdometryWriter, number, Bytes(8))));
    int passed = 0;
    for (int i = 0; i < 1000; ++i) {
        if (takes(Packet().data(OdometryWriter, number += 10'000, Bytes(8)))) ++passed;
    }
    EXPECT_LE(passed, 7);
    EXPECT_GE(passed, 5);
}

TEST_F(ScreenTest, AGapInTheRadioOfAMinuteAtAKilohertzIsNoJump) {
    ASSERT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 100'000, 10)));
    m_now += 60s;
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 159'000, 160'000, 700)));
    EXPECT_TRUE(takes(Packet().data(OdometryWriter, 160'001, Bytes(8))));
}

TEST_F(ScreenTest, GapsAreBoundedOneByOneAndTogether) {
    ASSERT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 200'000, 1)));
    EXPECT_TRUE(takes(Packet().gap(OdometryWriter, 1, 100'000, 8)));
    EXPECT_FALSE(takes(Packet().gap(OdometryWriter, 1, 200'000)));
    int passed = 0;
    for (int i = 0; i < 1000; ++i) passed += takes(Packet().gap(OdometryWriter, 1, 100'000)) ? 1 : 0;
    EXPECT_LE(passed, 10);
    m_now += 1s;
    EXPECT_TRUE(takes(Packet().gap(OdometryWriter, 1, 100'000)));
}

TEST_F(ScreenTest, CountsDoNotJump) {
    ASSERT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 5, 3'000'000)));
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 5, 3'000'100)));
    EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, 1, 5, 0xffffffff)));
    EXPECT_TRUE(takes(Packet().acknowledge(OdometryReader, 0x203, 5, 10)));
    EXPECT_FALSE(takes(Packet().acknowledge(OdometryReader, 0x203, 5, 0x7fffffff)));
    EXPECT_TRUE(
        takes(Packet().acknowledge(OdometryReader, 0x303, 5, 0x7fffffff)));  // of another writer of ours
    EXPECT_TRUE(takes(Packet().acknowledge(OdometryReader, 0x203, 5, 11)));
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 5, 2)));  // old: the library's to ignore
}

TEST_F(ScreenTest, FragmentsOfOneSampleFitEachOther) {
    const auto fragment = [](std::uint32_t start, unsigned size, std::uint32_t sample) {
        return Packet().fragments(OdometryWriter, 9, start, 1, size, sample, Bytes(size));
    };
    EXPECT_TRUE(takes(fragment(1, 100, 1000)));
    EXPECT_TRUE(takes(fragment(2, 100, 1000)));
    EXPECT_FALSE(takes(fragment(3, 200, 1000)));
    EXPECT_FALSE(takes(fragment(3, 100, 2000)));
    EXPECT_TRUE(takes(fragment(3, 100, 1000)));
    EXPECT_FALSE(takes(Packet().fragments(OdometryWriter, 10, 1, 1, 1000, 4'000'000'000, Bytes(1000))));
}

TEST_F(ScreenTest, SamplesThatAreNeverFinishedTakeBoundedMemory) {
    constexpr std::uint32_t Large = 16U << 20;
    int passed = 0;
    for (std::int64_t i = 1; i <= 100; ++i)
        passed += takes(Packet().fragments(OdometryWriter, i, 1, 1, 1000, Large, Bytes(1000))) ? 1 : 0;
    EXPECT_EQ(passed, 4);
    // Those that are finished cost nothing: 40 MB/s for a minute.
    m_now += 60s;
    for (std::int64_t number = 200; number < 800; ++number) {
        m_now += 100ms;
        for (std::uint32_t start = 1; start <= 63; start += 3) {
            ASSERT_TRUE(takes(
                Packet().fragments(OdometryWriter, number, start, 3, 21'000, 63 * 21'000, Bytes(63'000))))
                << number << " " << start;
        }
    }
}

TEST_F(ScreenTest, NumbersAndCountsGoAheadOnlyWhereAWriterSpokeFirst) {
    const screen::Place first = placeOf(8), second = placeOf(8, 50'000), third = placeOf(8, 50'001);
    ASSERT_TRUE(takes(Packet(2).announce(100, 8), first));
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 100, Bytes(8)), first));
    EXPECT_TRUE(takes(Packet(2).heartbeat(OdometryWriter, 91, 100, 5), first));
    EXPECT_TRUE(takes(Packet(2).acknowledge(OdometryReader, 0x203, 1, 5), first));
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 110, Bytes(8)), second));  // by another interface
    for (int i = 0; i < 100; ++i) {  // many small steps are none either
        static_cast<void>(takes(Packet(2).data(OdometryWriter, 111 + i, Bytes(8)), second));
        static_cast<void>(takes(Packet(2).heartbeat(OdometryWriter, 91, 100, 6 + i), second));
    }
    EXPECT_FALSE(takes(Packet(2).data(OdometryWriter, 210, Bytes(8)), second));
    EXPECT_FALSE(takes(Packet(2).gap(OdometryWriter, 100, 50'000), second));
    EXPECT_FALSE(takes(Packet(2).heartbeat(OdometryWriter, 50'000, 50'100, 6), third));
    EXPECT_FALSE(takes(Packet(2).heartbeat(OdometryWriter, 91, 100, 10'000), third));
    EXPECT_FALSE(takes(Packet(2).acknowledge(OdometryReader, 0x203, 1, 10'000), second));
    EXPECT_TRUE(takes(Packet(2).gap(OdometryWriter, 100, 50'000), first));
    EXPECT_TRUE(takes(Packet(2).acknowledge(OdometryReader, 0x203, 1, 10'000), first));
}

TEST_F(ScreenTest, AWriterGoesOnFromElsewhereWhereItsFirstPlaceIsSilent) {
    const screen::Place home = placeOf(8), second = placeOf(8, 50'000), third = placeOf(8, 50'001);
    ASSERT_TRUE(takes(Packet(2).announce(100, 8), home));
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 100, Bytes(8)), second));
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 101, Bytes(8)), third));
    for (int i = 0; i < 4; ++i) {  // something else still comes from there
        m_now += 1s;
        ASSERT_TRUE(takes(Packet(2).heartbeat(screen::entity::PublicationsWriter, 1, 1, 1), second));
    }
    EXPECT_FALSE(takes(Packet(2).data(OdometryWriter, 500, Bytes(8)), third));
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 500, Bytes(8)), home));
    m_now += 4s;
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 900, Bytes(8)), third));
}

TEST_F(ScreenTest, TheSamePortAtAnotherAddressIsTheSameWriter) {
    ASSERT_TRUE(takes(Packet(2).announce(100, 9), placeOf(8)));  // says that it is at 9, too
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 1, Bytes(8)), placeOf(8)));
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 200, Bytes(8)), placeOf(9))) << "the cable was pulled";
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 400, Bytes(8)), placeOf(8)));
}

TEST_F(ScreenTest, FromElsewhereNoFragmentsBeginAndNoAllowanceIsUsed) {
    const screen::Place own = placeOf(8), other = placeOf(8, 50'000);
    const auto fragment = [](std::int64_t number, std::uint32_t sample) {
        return Packet(2).fragments(OdometryWriter, number, 1, 1, 100, sample, Bytes(100));
    };
    ASSERT_TRUE(takes(Packet(2).announce(100, 8), own));
    EXPECT_TRUE(takes(fragment(1, 1'000), own));
    EXPECT_FALSE(takes(fragment(2, 500), other)) << "the true ones would not fit it";
    EXPECT_TRUE(takes(fragment(2, 1'000), own));
    EXPECT_TRUE(takes(fragment(2, 1'000), other)) << "of a sample that the writer began";
    for (int i = 0; i < 100; ++i) EXPECT_FALSE(takes(Packet(2).gap(OdometryWriter, 1, 100'000), other));
    EXPECT_TRUE(takes(Packet(2).gap(OdometryWriter, 3, 60'000), own)) << "its GAPs are not used up";
}

}  // namespace
}  // namespace leitstand::test
