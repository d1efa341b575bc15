#include "transport/screen/screen.h"

#include <thread>

#include <gmock/gmock.h>

#include "tests/transport/screen/screen_fixture.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using screen::Screen, screen::Moment;
using Why = ScreenDrop::Kind;

class RelayedScreen : public ScreenTest {
protected:
    RelayedScreen() : ScreenTest({.relayed = true}) {}
};
class EncryptedScreen : public testing::Test {
protected:
    bool takes(const Packet& packet) { return m_screen.passes(packet.bytes(), placeOf(7)); }
    Screen m_screen{screen::ScreenSettings{.encrypted = true}};
};

TEST_F(ScreenTest, OthersDoNotSpeakInARobotsName) {
    for (const auto& from : {placeOf(8), placeOf(7, 40'001)}) {
        EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, 1, 1'000), from));
        EXPECT_FALSE(takes(Packet().data(OdometryWriter, 1, Bytes(8)), from));
        EXPECT_FALSE(takes(Packet().acknowledge(OdometryReader, 0x203, 5, 10), from));
        EXPECT_FALSE(takes(Packet().submessage(0x09, 2, {}), from));  // would let it live on
        EXPECT_FALSE(takes(Packet().announce(0), from));              // would end its lease
        EXPECT_FALSE(takes(Packet()
                               .submessage(0x33, 0, Bytes(20))
                               .submessage(0x30, 0, Bytes(8))
                               .submessage(0x34, 0, Bytes(20)),
                           from));
    }
    EXPECT_EQ(dropped(Why::Impostor), 12U);
    EXPECT_TRUE(takes(Packet().announce(), placeOf(8)));  // the same once more harms nobody
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 1'000)));
}

TEST_F(ScreenTest, NobodyEndsAnotherParticipantOrItsEndpoints) {
    ASSERT_TRUE(takes(Packet(2).announce(), placeOf(8)));
    EXPECT_FALSE(takes(Packet(1).endParticipant(1), placeOf(8)));
    EXPECT_FALSE(takes(Packet(2).endParticipant(1), placeOf(8)));
    EXPECT_FALSE(takes(Packet(2).end(1, screen::entity::PublicationsWriter, OdometryWriter), placeOf(8)));
    EXPECT_TRUE(takes(Packet(1).end(1, screen::entity::PublicationsWriter, OdometryWriter)));
    EXPECT_TRUE(takes(Packet(1).endParticipant(1)));
    EXPECT_TRUE(takes(Packet().announce(), placeOf(9)));  // it may come again from elsewhere
}

TEST_F(ScreenTest, WhileAParticipantIsNewOnlyItsHomeEndsOrChangesIt) {
    const screen::Place home = placeOf(9), forger = placeOf(9, 50'000);
    ASSERT_TRUE(takes(Packet(3).announce(100, 9), home));
    EXPECT_TRUE(takes(Packet(3).announce(100, 9), forger)) << "the same, from another socket of its";
    EXPECT_TRUE(takes(Packet(3).data(OdometryWriter, 1, Bytes(8)), forger));
    EXPECT_FALSE(takes(Packet(3).announce(1, 9), forger));
    EXPECT_FALSE(takes(Packet(3).endParticipant(3), forger));
    EXPECT_EQ(dropped(Why::Impostor), 2U);
    EXPECT_TRUE(takes(Packet(3).announce(90, 9), home));
    EXPECT_TRUE(takes(Packet(3).endParticipant(3), home));
    ASSERT_TRUE(takes(Packet(4).announce(100, 9), home));
    m_now += 4s;
    EXPECT_TRUE(takes(Packet(4).announce(90, 9), forger)) << "its home is silent: an interface went";
}

TEST_F(ScreenTest, WhoItIsIsProvenFromOnePlaceThatNeedNotBeItsHome) {
    const screen::Place group = placeOf(9), single = placeOf(9, 50'000), forger = placeOf(9, 50'001);
    const auto proof = [](std::int64_t number) {
        return Packet(3).data(screen::entity::AuthenticationWriter, number, Packet::identityToken());
    };
    ASSERT_TRUE(takes(Packet(3).announce(100, 9), group));
    EXPECT_TRUE(takes(proof(1), single)) << "as Fast DDS speaks to the group and to one";
    EXPECT_FALSE(takes(proof(2), forger));
    EXPECT_EQ(dropped(Why::Impostor), 1U);
    EXPECT_TRUE(takes(proof(2), single));
}

TEST_F(ScreenTest, EndpointsAreAnnouncedAndTakenBackFromOnePlace) {
    const screen::Place home = placeOf(9), second = placeOf(9, 50'000);
    const screen::EntityId writer = screen::entity::PublicationsWriter;
    ASSERT_TRUE(takes(Packet(3).announce(100, 9), home));
    EXPECT_TRUE(takes(Packet(3).announceEndpoint(OdometryWriter), second)) << "announced from another socket";
    EXPECT_FALSE(takes(Packet(3).end(3, writer, OdometryWriter), home));
    EXPECT_FALSE(takes(Packet(3).announceEndpoint(OdometryWriter, true, 2), placeOf(9, 50'001)));
    EXPECT_EQ(dropped(Why::Impostor), 2U);
    EXPECT_TRUE(takes(Packet(3).end(3, writer, OdometryWriter), second));
}

TEST_F(ScreenTest, ManyMadeUpWritersKeepNoAnnouncementsOut) {
    ASSERT_TRUE(takes(Packet(3).announce(100, 9), placeOf(9)));
    for (unsigned i = 0; i < 200; ++i)
        static_cast<void>(takes(Packet(3).heartbeat(0x00100003 + (i << 8), 1, 1), placeOf(9, 50'000)));
    EXPECT_TRUE(takes(Packet(3).announceEndpoint(OdometryWriter), placeOf(9)));
}

TEST_F(ScreenTest, ManyPortsDriveNobodyOutFromWhereItSpeaks) {
    const screen::Place own = placeOf(9, 45'000);
    ASSERT_TRUE(takes(Packet(3).announce(100, 9), placeOf(9)));
    ASSERT_TRUE(takes(Packet(3).announceEndpoint(OdometryWriter), own));
    ASSERT_TRUE(takes(Packet(3).data(OdometryWriter, 1, Bytes(8)), own));
    for (int port = 50'000; port < 50'050; ++port)
        static_cast<void>(takes(Packet(3).data(OdometryWriter, 1, Bytes(8)), placeOf(9, port)));
    EXPECT_FALSE(takes(Packet(3).gap(OdometryWriter, 1, 50'000), placeOf(9, 50'049)));
    EXPECT_TRUE(takes(Packet(3).data(OdometryWriter, 500, Bytes(8)), own));
    EXPECT_TRUE(takes(Packet(3).announce(90, 9), placeOf(9)));
}

TEST_F(ScreenTest, APacketThatIsRefusedMakesNoPlaceItsOwn) {
    const screen::Place own = placeOf(9, 45'000), forger = placeOf(9, 50'000);
    ASSERT_TRUE(takes(Packet(3).announce(100, 9), placeOf(9)));
    EXPECT_FALSE(takes(Packet(3).gap(screen::entity::PublicationsWriter, 1, 1 << 20), forger));
    EXPECT_TRUE(takes(Packet(3).announceEndpoint(OdometryWriter), own));
    EXPECT_FALSE(takes(Packet(3).heartbeat(screen::entity::PublicationsWriter, 1, 1), forger))
        << "nothing of discovery";
}

TEST_F(ScreenTest, WhoIsTurnedAwayTakesNoHomeOver) {
    ASSERT_TRUE(takes(Packet(2).announce(100, 8), placeOf(8)));
    ASSERT_TRUE(takes(Packet(2).data(OdometryWriter, 1, Bytes(8)), placeOf(8, 50'000)));
    m_now += 60s;
    ASSERT_TRUE(takes(Packet(2).data(OdometryWriter, 2, Bytes(8)), placeOf(8, 50'000)));
    EXPECT_FALSE(takes(Packet(2).announce(1, 8), placeOf(10)));
    EXPECT_TRUE(takes(Packet(2).announce(90, 8), placeOf(8)));
}

TEST_F(ScreenTest, ARobotWithTwoInterfacesIsHeardOnBoth) {
    ASSERT_TRUE(takes(Packet(2).announce(100, 9), placeOf(8)));
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 1, Bytes(8)), placeOf(9)));  // says that it is there too
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 2, Bytes(8)), placeOf(8, 50'000)));
    m_now += 60s;
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 3, Bytes(8)), placeOf(9)));
    EXPECT_FALSE(takes(Packet(2).data(OdometryWriter, 3, Bytes(8)), placeOf(10)));
}

TEST_F(ScreenTest, ARobotThatOnlyAnnouncedItselfMaySpeakFromAnotherPortLate) {
    ASSERT_TRUE(takes(Packet(2).announce(100, 8), placeOf(8)));
    for (int i = 0; i < 60; ++i) {
        m_now += 1s;
        ASSERT_TRUE(takes(Packet(2).announce(100, 8), placeOf(8)));
    }
    EXPECT_TRUE(takes(Packet(2).data(OdometryWriter, 3, Bytes(8)), placeOf(8, 50'000)));
    EXPECT_FALSE(takes(Packet(2).data(OdometryWriter, 3, Bytes(8)), placeOf(8, 50'001)));
}

TEST_F(ScreenTest, ARobotThatWasSilentMayComeBackFromElsewhere) {
    ASSERT_TRUE(takes(Packet().data(OdometryWriter, 1, Bytes(8))));
    m_now += 4s;
    EXPECT_TRUE(takes(Packet().data(OdometryWriter, 2, Bytes(8)), placeOf(12)));
}

TEST_F(ScreenTest, WhatAHostMayHaveIsEnoughAndBounded) {
    for (int i = 100; i < 164; ++i) ASSERT_TRUE(takes(Packet(i).announce(), placeOf(20, i))) << i;
    EXPECT_FALSE(takes(Packet(164).announce(), placeOf(20, 164)));
    EXPECT_TRUE(takes(Packet(164).announce(), placeOf(21, 164)));  // another host
    EXPECT_EQ(dropped(Why::TooMany), 1U);
    m_now += 102s;
    EXPECT_TRUE(takes(Packet(165).announce(), placeOf(20, 165)));  // the others' leases are over
}

TEST_F(ScreenTest, KilledProcessesTakeNoPlaceOfThoseThatSpeak) {
    for (int i = 0; i < 100; ++i) {  // one that is started again and again
        ASSERT_TRUE(takes(Packet(100 + i).announce(), placeOf(20, 100 + i))) << i;
        for (unsigned endpoint = 0; endpoint < 60; ++endpoint) {
            const auto packet = Packet(100 + i).announceEndpoint(endpoint << 8 | 3, true, endpoint + 1);
            ASSERT_TRUE(takes(packet, placeOf(20, 100 + i))) << i << " " << endpoint;
        }
        m_now += 800ms;
    }
    EXPECT_EQ(dropped(Why::TooMany), 0U);
}

TEST_F(ScreenTest, SilentParticipantsAreBoundedToo) {
    int taken = 0;
    for (int i = 0; i < 400; ++i) {
        taken += takes(Packet(100 + i).announce(), placeOf(20, 100 + i)) ? 1 : 0;
        m_now += 240ms;
    }
    EXPECT_EQ(taken, 192);
}

TEST_F(ScreenTest, AParticipantWithTooManyEndpointsIsRefusedWhole) {
    for (int one = 0; one < 5; ++one) {
        ASSERT_TRUE(takes(Packet(200 + one).announce(), placeOf(20, 200 + one)));
        for (unsigned i = 0; i < 1000; ++i) {
            const bool passes =
                takes(Packet(200 + one).announceEndpoint(i << 8 | 3, true, i + 1), placeOf(20, 200 + one));
            ASSERT_EQ(passes, one < 4 || i < 96) << one << " " << i;
        }
    }
    EXPECT_FALSE(takes(Packet(204).announce(), placeOf(20, 204)));
    EXPECT_FALSE(takes(Packet(204).data(OdometryWriter, 1, Bytes(8)), placeOf(20, 204)));
    EXPECT_TRUE(takes(Packet(203).data(OdometryWriter, 1, Bytes(8)), placeOf(20, 203)));
    m_now += 102s;  // the library forgets it, and so do we
    EXPECT_TRUE(takes(Packet(204).announce(), placeOf(20, 204)));
}

TEST_F(ScreenTest, StrangersHaveABudgetAndParticipantsHaveNone) {
    int passed = 0;
    for (int i = 0; i < 2'000; ++i)
        passed += takes(Packet(50).data(OdometryWriter, i + 1, Bytes(8)), placeOf(30)) ? 1 : 0;
    EXPECT_EQ(passed, 400);
    EXPECT_EQ(dropped(Why::Flood), 1'600U);
    for (int i = 0; i < 2'000; ++i) ASSERT_TRUE(takes(Packet().data(OdometryWriter, i + 1, Bytes(8))));
    EXPECT_TRUE(takes(Packet(50).announce(), placeOf(30)));
    EXPECT_TRUE(takes(Packet(50).data(OdometryWriter, 9, Bytes(8)), placeOf(30)));
}

TEST_F(ScreenTest, ServersAnnounceOthersOnlyWhereThereIsOne) {
    const auto relayed =
        Packet(9).data(screen::entity::ParticipantWriter, 1, Packet(10).announcement(20, 8, "x"));
    ASSERT_TRUE(takes(Packet(9).announce(), placeOf(40)));
    EXPECT_FALSE(takes(relayed, placeOf(40)));
    EXPECT_EQ(dropped(Why::Impostor), 1U);
}

TEST_F(RelayedScreen, AParticipantThatAServerAnnouncedSpeaksForItself) {
    ASSERT_TRUE(takes(Packet(9).announce(), placeOf(40)));
    ASSERT_TRUE(
        takes(Packet(9).data(screen::entity::ParticipantWriter, 1, Packet(10).announcement(20, 8, "x")),
              placeOf(40)));
    for (int i = 0; i < 1'000; ++i)
        ASSERT_TRUE(takes(Packet(10).data(OdometryWriter, i + 1, Bytes(8)), placeOf(8))) << i;
    EXPECT_FALSE(takes(Packet(10).data(OdometryWriter, Huge, Bytes(8)), placeOf(8)));
}

TEST_F(ScreenTest, WhatIsAnnouncedIsReadToItsEnd) {
    const auto announced = [](const Bytes& more) {
        Packet packet(60);
        const Bytes payload =
            packet.word()
                .append(packet.parameters())
                .parameter(0x0050, ByteWriter().prefix(prefixOf(60)).entity(0x000001c1).bytes)
                .append(more)
                .parameter(1, {})
                .bytes;
        return packet.data(screen::entity::ParticipantWriter, 1, payload);
    };
    const auto place = placeOf(30);
    const auto property = ByteWriter().u32(1).text("name").text("value").bytes;
    EXPECT_TRUE(takes(announced(ByteWriter().parameter(0x0059, property).bytes), place));
    const Bytes hostile[] = {
        ByteWriter().parameter(0x0059, ByteWriter().u32(0xffffffff).text("name").text("value").bytes).bytes,
        ByteWriter().parameter(0x0059, ByteWriter().u32(1).u32(0x7fffffff).text("value").bytes).bytes,
        ByteWriter()
            .parameter(0x1001, ByteWriter().text("DDS:Auth:PKI-DH:1.0").u32(0xfffffff0).u32(0).bytes)
            .bytes,
        ByteWriter().parameter(0x0062, ByteWriter().u32(8).zeros(4).bytes).bytes,
        ByteWriter()
            .parameter(0x0062, ByteWriter().u32(4).u32(0x41414141).bytes)
            .bytes,  // no zero at its end
        ByteWriter().parameter(0x002c, ByteWriter().u32(0xfffffffc).bytes).bytes,
        ByteWriter().parameter(0x0002, Bytes(4)).bytes,
        ByteWriter().parameter(0x0032, Bytes(20)).bytes};
    for (const Bytes& one : hostile) EXPECT_FALSE(takes(announced(one), place));
    EXPECT_EQ(dropped(Why::NoRtps), std::size(hostile));
}

TEST_F(EncryptedScreen, OnlyDiscoveryAndAuthenticationArePlain) {
    EXPECT_TRUE(takes(Packet().announce()));
    EXPECT_FALSE(takes(Packet().announceEndpoint(OdometryWriter)));
    EXPECT_FALSE(takes(Packet().data(OdometryWriter, 1, Bytes(8))));
    EXPECT_FALSE(takes(Packet().heartbeat(OdometryWriter, 1, 2)));
    EXPECT_FALSE(takes(Packet().acknowledge(OdometryReader, 0x203, 5, 10)));
    EXPECT_FALSE(takes(Packet().gap(OdometryWriter, 1, 2)));
    Bytes token = Packet::identityToken();
    EXPECT_TRUE(takes(Packet().data(screen::entity::AuthenticationWriter, 1, token)));
    token.resize(token.size() - 4);
    EXPECT_FALSE(takes(Packet().data(screen::entity::AuthenticationWriter, 1, token)));
    EXPECT_TRUE(takes(Packet()
                          .submessage(0x33, 0, Bytes(20))
                          .submessage(0x30, 0, Bytes(8))
                          .submessage(0x34, 0, Bytes(20))
                          .statistics()));
    EXPECT_TRUE(takes(Packet()
                          .submessage(0x33, 0, Bytes(20))
                          .heartbeat(OdometryWriter, 1, 2)
                          .submessage(0x34, 0, Bytes(20))));  // signed
    EXPECT_TRUE(takes(Packet()
                          .submessage(0x0e, 0, Bytes(12))
                          .submessage(0x31, 0, Bytes(20))
                          .submessage(0x30, 0, Bytes(8))
                          .submessage(0x32, 0, Bytes(20))));
}

TEST_F(EncryptedScreen, WhereDiscoveryIsHeardIsWhatParticipantsAnnounceForNothingElse) {
    EXPECT_FALSE(m_screen.isDiscoveryPort(7410));
    EXPECT_TRUE(takes(Packet(1).announcePorts({7400, 7410}, {7411})));
    EXPECT_TRUE(takes(Packet(2).announcePorts({7412, 50'000}, {7413, 50'000})));  // one port for all
    for (const std::uint16_t port : std::vector<std::uint16_t>{7400, 7410, 7412})
        EXPECT_TRUE(m_screen.isDiscoveryPort(port)) << port;
    for (const std::uint16_t port : std::vector<std::uint16_t>{7411, 7413, 50'000})
        EXPECT_FALSE(m_screen.isDiscoveryPort(port)) << port;
    EXPECT_TRUE(takes(Packet(3).announcePorts({7414}, {7412})));  // what two say that differ is no port of it
    EXPECT_FALSE(m_screen.isDiscoveryPort(7412));
}

TEST_F(ScreenTest, WhatComesTwicePassesTwice) {
    const auto twice = [this](const Packet& packet) { return takes(packet) && takes(packet); };
    EXPECT_TRUE(twice(Packet().announce()));
    EXPECT_TRUE(twice(Packet().announceEndpoint(0x00000203, true, 2)));
    EXPECT_TRUE(twice(Packet().heartbeat(screen::entity::PublicationsWriter, 1, 2, 5)));
    EXPECT_TRUE(twice(Packet().acknowledge(0x000003c7, 0x000003c2, 2, 9)));
    EXPECT_TRUE(twice(Packet().gap(screen::entity::SubscriptionsWriter, 1, 5)));
    EXPECT_EQ(m_screen.drops().size(), 0U);
}

TEST_F(ScreenTest, SendersAreToldApartAndInBounds) {
    for (int host = 1; host <= 200; ++host) {
        for (int i = 0; i < 3; ++i)
            EXPECT_FALSE(takes(Packet().submessage(0x80, 0, Bytes(60), 56), placeOf(host)));
    }
    const auto drops = m_screen.drops();
    ASSERT_EQ(drops.size(), 17U);
    EXPECT_EQ(toString(drops[0]), "somebody sends what is no RTPS: 3 packets from 10.0.0.1");
    EXPECT_EQ(toString(drops[16]), "somebody sends what is no RTPS: 552 packets from many addresses");
    EXPECT_EQ(toString(ScreenDrop{Why::NoRtps, "10.0.0.7", 1'234'567}),
              "somebody sends what is no RTPS: 1,234,567 packets from 10.0.0.7");
}

TEST_F(ScreenTest, ManyThreadsMayAsk) {
    std::vector<std::jthread> threads;
    for (int one = 0; one < 4; ++one) {
        threads.emplace_back([this, one] {
            for (int i = 0; i < 20'000; ++i) {
                const int number = 300 + (i * 7 + one) % 90;
                const bool passes = m_screen.passes(
                    i % 3 == 0 ? Packet(number).announce(1).bytes()
                               : Packet(number).announceEndpoint(std::uint32_t(i) << 8 | 3).bytes(),
                    placeOf(50 + one, number), m_now + i * 1ms);
                static_cast<void>(passes);
            }
        });
    }
    threads.clear();
    EXPECT_TRUE(takes(Packet().heartbeat(OdometryWriter, 1, 1)));
}

}  // namespace
}  // namespace leitstand::test
