#include "transport/screen/traffic.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/transport/screen/packets.h"

namespace leitstand::test {
namespace {

using screen::Traffic, screen::trafficOf;

Traffic of(const Packet& packet) {
    return trafficOf(packet.bytes());
}
/// Begins with what stands before the submessages of most datagrams.
Packet addressed(bool little = true) {
    return Packet(1, little).submessage(0x0e, 0, Bytes(12)).submessage(0x09, 0, Bytes(8));
}
Packet encryptedMessage() {
    return Packet()
        .submessage(0x33, 0, Bytes(20))
        .submessage(0x30, 0, ByteWriter(false).u32(40).zeros(40).bytes)
        .submessage(0x34, 0, Bytes(20));
}

TEST(Traffic, EveryKindOfSubmessageOfAWriterThatAllHaveIsDiscovery) {
    for (const bool little : {true, false}) {
        for (const screen::EntityId writer :
             {0x000100c2U, 0x000003c2U, 0x000004c2U, 0x000200c2U, 0x000201c3U, 0x000300c3U, 0xff0003c2U,
              0xff0004c2U, 0xff0101c2U, 0xff0200c2U, 0xff0202c3U}) {
            EXPECT_EQ(of(addressed(little).data(writer, 1, Bytes(8))), Traffic::Discovery);
            EXPECT_EQ(of(addressed(little).heartbeat(writer, 1, 3)), Traffic::Discovery);
            EXPECT_EQ(of(addressed(little).gap(writer, 1, 3, 7)), Traffic::Discovery);
            EXPECT_EQ(of(addressed(little).acknowledge(writer + 5, writer, 1, 1, 9)), Traffic::Discovery);
            EXPECT_EQ(of(addressed(little).fragments(writer, 1, 1, 1, 100, 100, Bytes(100))),
                      Traffic::Discovery);
        }
    }
}

TEST(Traffic, SubmessagesOfTopicsAreSamples) {
    for (const bool little : {true, false}) {
        Packet packet = addressed(little);
        packet.data(OdometryWriter, 1, Bytes(8))
            .heartbeat(OdometryWriter, 1, 3)
            .gap(OdometryWriter, 1, 3)
            .acknowledge(OdometryReader, 0x203, 1, 1)
            .fragments(OdometryWriter, 1, 1, 1, 100, 100, Bytes(100))
            .statistics();
        EXPECT_EQ(of(packet), Traffic::Samples);
        EXPECT_EQ(of(packet.heartbeat(screen::entity::PublicationsWriter, 1, 1)), Traffic::Discovery);
    }
}

TEST(Traffic, WhatIsEncryptedCannotBeSeenAndWhatIsSignedCan) {
    EXPECT_EQ(of(encryptedMessage()), Traffic::Encrypted);
    EXPECT_EQ(of(Packet()
                     .submessage(0x31, 0, Bytes(20))
                     .submessage(0x30, 0, ByteWriter(false).u32(4).zeros(4).bytes)
                     .submessage(0x32, 0, Bytes(20))),
              Traffic::Encrypted);
    Packet isSigned = Packet().submessage(0x33, 0, Bytes(20));
    EXPECT_EQ(of(isSigned.data(OdometryWriter, 1, Bytes(8)).submessage(0x34, 0, Bytes(20))),
              Traffic::Samples);
    EXPECT_EQ(of(isSigned.heartbeat(0xff0003c2, 1, 1)), Traffic::Discovery);
}

TEST(Traffic, TheBeginningOfASampleIsEnough) {
    const Bytes whole = addressed().data(0x000003c2, 1, Bytes(900)).bytes();
    const std::size_t writerEnds = 20 + 16 + 12 + 4 + 12;
    EXPECT_EQ(trafficOf(std::span(whole).first(writerEnds)), Traffic::Discovery);
    EXPECT_EQ(trafficOf(std::span(whole).first(writerEnds - 1)), Traffic::Samples);
    EXPECT_EQ(trafficOf({}), Traffic::Samples);
}

TEST(Traffic, AnythingIsReadWithinItsBytes) {
    std::mt19937 random(5);
    const Bytes whole = addressed().data(OdometryWriter, 1, Bytes(40)).heartbeat(0x000003c2, 1, 1).bytes();
    for (int i = 0; i < 20'000; ++i) {
        Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(random() % whole.size()));
        for (int changes = 0; changes < 3 && !bytes.empty(); ++changes)
            bytes[random() % bytes.size()] = static_cast<std::byte>(random());
        static_cast<void>(trafficOf(Bytes(bytes)));  // its bytes end where its memory ends
    }
}

}  // namespace
}  // namespace leitstand::test
