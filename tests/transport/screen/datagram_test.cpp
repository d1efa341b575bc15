#include "transport/screen/datagram.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/transport/screen/packets.h"

namespace leitstand::test {
namespace {

using screen::Datagram, screen::Fault, screen::Kind, screen::parse;

Fault faultOf(const Packet& packet) {
    Datagram into;
    return parse(packet.bytes(), into);
}
/// A packet with all that may be in one.
Packet everything(bool little) {
    Packet packet(1, little);
    packet.submessage(0x0e, 0, Bytes(12)).submessage(0x09, 0, Bytes(8)).submessage(0x09, 2, {});
    packet.announce().announceEndpoint(OdometryWriter);
    packet.heartbeat(OdometryWriter, 1, 0)
        .gap(OdometryWriter, 1, 5, 40)
        .acknowledge(OdometryReader, 0x203, 9, 3, 7);
    packet.data(
        OdometryWriter, 5, Bytes(12),
        packet.word().parameter(0x0070, Bytes(16)).parameter(0x0071, Bytes(4)).parameter(1, {}).bytes);
    packet.fragments(OdometryWriter, 6, 2, 2, 100, 350, Bytes(200));
    packet.submessage(0x12, 0,
                      packet.word().entity(1).entity(2).sequenceNumber(3).u32(1).u32(5).u32(0).u32(1).bytes);
    packet.submessage(0x13, 0, packet.word().entity(1).entity(2).sequenceNumber(3).u32(1).u32(1).bytes);
    packet.submessage(0x0c, 0, ByteWriter().zeros(8).prefix(prefixOf(2)).bytes).submessage(0x0d, 0, Bytes(8));
    packet.submessage(0x0f, 0, packet.word().u32(1).zeros(24).bytes).submessage(0x01, 0, Bytes(4));
    return packet.submessage(0x81, 0, Bytes(4)).statistics();
}
Bytes cryptoHeader() {
    return Bytes(20);
}
Bytes cryptoFooter(std::uint32_t macs, std::size_t there) {
    return ByteWriter(false).zeros(16).u32(macs).zeros(there * 20).bytes;
}
Bytes cryptoBody(std::uint32_t size, std::size_t there) {
    return ByteWriter(false).u32(size).zeros(there).bytes;
}

TEST(Datagram, AllKindsOfBothByteOrdersAreTakenApart) {
    for (const bool little : {true, false}) {
        Datagram into;
        EXPECT_EQ(parse(everything(little).bytes(), into), "") << little;
        ASSERT_EQ(into.submessages.size(), 18U);
        EXPECT_EQ(into.submessages[5].last, 0);
        EXPECT_EQ(into.submessages[6].gapped, 4);
        EXPECT_EQ(into.submessages[6].last, 44);
        EXPECT_EQ(into.submessages[7].count, 3U);
        EXPECT_TRUE(into.submessages[8].key.has_value());
        EXPECT_EQ(into.submessages[8].payload.size(), 12U);
        EXPECT_EQ(into.submessages[9].sampleSize, 350U);
        EXPECT_EQ(into.sender, prefixOf(1));
        EXPECT_EQ(into.speaker, prefixOf(2));
        EXPECT_EQ(into.submessages.back().kind, Kind::Statistics);
    }
}

TEST(Datagram, EveryCutIsRefusedOrHasNothingButWholeSubmessages) {
    const Bytes whole = everything(true).bytes();
    Datagram into;
    ASSERT_EQ(parse(whole, into), "");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));  // its own memory
        EXPECT_TRUE(!parse(cut, into).empty() || into.submessages.size() < 18U) << size;
    }
}

TEST(Datagram, StatisticsPassOnlyAtTheEndAndAsLongAsTheLibraryMakesThem) {
    EXPECT_EQ(faultOf(Packet().heartbeat(OdometryWriter, 1, 1).statistics()), "");
    EXPECT_NE(faultOf(Packet().statistics().heartbeat(OdometryWriter, 1, 1)), "");
    EXPECT_NE(faultOf(Packet().statistics().statistics()), "");
    EXPECT_NE(faultOf(Packet().submessage(0x80, 0, Bytes(60), 56)), "");  // what aborted every process
    EXPECT_NE(faultOf(Packet().submessage(0x80, 0, Bytes(56), 0)), "");
    for (const std::size_t size : {0U, 4U, 52U, 60U})
        EXPECT_NE(faultOf(Packet().submessage(0x80, 0, Bytes(size))), "");
    EXPECT_NE(faultOf(Packet(1, false).submessage(0x80, 0, Bytes(56), 0x3800)), "");
}

TEST(Datagram, WhatIsNoRtpsIsRefused) {
    Datagram into;
    EXPECT_NE(parse({}, into), "");
    EXPECT_NE(parse(Bytes(1500), into), "");
    Bytes other = Packet().heartbeat(OdometryWriter, 1, 1).bytes();
    other[4] = std::byte{3};
    EXPECT_NE(parse(other, into), "");
    EXPECT_NE(faultOf(Packet()), "");  // a header alone
    EXPECT_NE(faultOf(Packet().submessage(0x07, 0, Bytes(12))), "");
    EXPECT_NE(faultOf(Packet().submessage(0x15, 4, Bytes(8), 4000)), "");
}

TEST(Datagram, NumbersThatAreNoRangeAreRefused) {
    constexpr std::int64_t Huge = std::int64_t(1) << 62;
    EXPECT_EQ(faultOf(Packet().heartbeat(OdometryWriter, 5, 4)), "");
    EXPECT_NE(faultOf(Packet().heartbeat(OdometryWriter, 5, 3)), "");
    EXPECT_NE(faultOf(Packet().heartbeat(OdometryWriter, 0, 3)), "");
    EXPECT_NE(faultOf(Packet().heartbeat(OdometryWriter, -Huge, Huge)), "");
    EXPECT_NE(faultOf(Packet().gap(OdometryWriter, 0, 3)), "");
    EXPECT_NE(faultOf(Packet().gap(OdometryWriter, 4, 3)), "");  // an assertion of the library
    EXPECT_NE(faultOf(Packet().gap(OdometryWriter, 4, -3)), "");
    EXPECT_NE(faultOf(Packet().gap(OdometryWriter, 4, 8, 257)), "");
    EXPECT_EQ(faultOf(Packet().gap(OdometryWriter, 1, INT64_MAX, 256)), "");  // the windows' to judge
    EXPECT_EQ(faultOf(Packet().acknowledge(OdometryReader, OdometryWriter, 0, 1)), "");
    EXPECT_NE(faultOf(Packet().acknowledge(OdometryReader, OdometryWriter, 0, 1, 2)), "");
    EXPECT_NE(faultOf(Packet().acknowledge(OdometryReader, OdometryWriter, -1, 1)), "");
    EXPECT_NE(faultOf(Packet().acknowledge(OdometryReader, OdometryWriter, 1, 1, 0xffffffff)), "");
    EXPECT_NE(faultOf(Packet().data(OdometryWriter, 0, Bytes(8))), "");
}

TEST(Datagram, PayloadsAndFieldsFitIntoTheirSubmessage) {
    const auto data = [](unsigned flags, unsigned fields, const Bytes& rest) {
        return Packet().submessage(0x15, flags,
                                   ByteWriter()
                                       .u16(0)
                                       .u16(fields)
                                       .entity(0)
                                       .entity(OdometryWriter)
                                       .sequenceNumber(1)
                                       .append(rest)
                                       .bytes);
    };
    EXPECT_EQ(faultOf(data(4, 16, Bytes(4))), "");
    EXPECT_NE(faultOf(data(4, 16, Bytes(3))), "");
    EXPECT_NE(faultOf(data(12, 16, Bytes(8))), "");  // sample and key at once
    EXPECT_NE(faultOf(data(8, 16, {})), "");
    EXPECT_NE(faultOf(data(0, 16, Bytes(8))), "");
    for (const unsigned fields : {0U, 12U, 20U, 0x7fffU, 0xffffU})
        EXPECT_NE(faultOf(data(4, fields, Bytes(8))), "");
}

TEST(Datagram, ParameterListsEndAndHoldWhatTheySay) {
    const auto withQos = [](const Bytes& qos) { return Packet().data(OdometryWriter, 1, Bytes(8), qos); };
    EXPECT_EQ(faultOf(withQos(ByteWriter().parameter(0x0070, Bytes(16)).parameter(1, {}).bytes)), "");
    EXPECT_EQ(faultOf(withQos(ByteWriter().parameter(0x7abc, Bytes(8)).parameter(1, {}).bytes)), "");
    EXPECT_NE(faultOf(withQos(ByteWriter().parameter(0x0070, Bytes(16)).bytes)), "");
    EXPECT_NE(faultOf(withQos(ByteWriter().parameter(0x0070, Bytes(12)).parameter(1, {}).bytes)), "");
    EXPECT_NE(faultOf(withQos(ByteWriter().parameter(0x0071, {}).parameter(1, {}).bytes)), "");
    EXPECT_NE(faultOf(withQos(ByteWriter().parameter(0x7abc, Bytes(6)).zeros(2).parameter(1, {}).bytes)), "");
    EXPECT_NE(faultOf(withQos(ByteWriter().u16(0x7abc).u16(0xfffc).zeros(8).bytes)), "");
}

TEST(Datagram, FragmentsAreOfTheirSample) {
    const auto made = [](std::uint32_t start, unsigned count, unsigned size, std::uint32_t sample,
                         std::size_t there) {
        return faultOf(Packet().fragments(OdometryWriter, 1, start, count, size, sample, Bytes(there)));
    };
    EXPECT_EQ(made(1, 1, 100, 350, 100), "");
    EXPECT_EQ(made(4, 1, 100, 350, 50), "");
    EXPECT_EQ(made(4, 1, 100, 350, 52), "");
    EXPECT_NE(made(4, 1, 100, 350, 48), "");  // the library would read behind it
    EXPECT_NE(made(1, 1, 100, 350, 96), "");
    EXPECT_NE(made(1, 1, 100, 350, 104), "");
    EXPECT_NE(made(0, 1, 100, 350, 100), "");
    EXPECT_NE(made(1, 0, 100, 350, 0), "");
    EXPECT_NE(made(5, 1, 100, 350, 100), "");
    EXPECT_NE(made(4, 2, 100, 350, 150), "");
    EXPECT_NE(made(1, 1, 0, 350, 0), "");
    EXPECT_NE(made(1, 1, 100, 0, 0), "");
    EXPECT_NE(made(0xffffffff, 0xffff, 0xffff, 0xffffffff, 100), "");
}

TEST(Datagram, SecureEnvelopesAreWhole) {
    const auto message = [](const Bytes& body, const Bytes& footer) {
        return Packet()
            .submessage(0x33, 0, cryptoHeader())
            .submessage(0x30, 0, body)
            .submessage(0x34, 0, footer);
    };
    EXPECT_EQ(faultOf(message(cryptoBody(40, 40), cryptoFooter(2, 2)).statistics()), "");
    EXPECT_NE(faultOf(message(cryptoBody(44, 40), cryptoFooter(0, 0))), "");
    EXPECT_NE(faultOf(message(cryptoBody(40, 40), cryptoFooter(3, 2))), "");
    EXPECT_NE(faultOf(message(cryptoBody(40, 40), cryptoFooter(0xffffffff, 2))), "");
    EXPECT_NE(faultOf(message(cryptoBody(40, 40), Bytes(8))), "");
    EXPECT_NE(faultOf(message(cryptoBody(40, 40), cryptoFooter(0, 0)).heartbeat(OdometryWriter, 1, 1)), "");
    EXPECT_NE(faultOf(Packet().submessage(0x33, 0, Bytes(16))), "");
    EXPECT_NE(faultOf(Packet().submessage(0x33, 0, cryptoHeader()).submessage(0x30, 0, cryptoBody(4, 4))),
              "");
    EXPECT_NE(faultOf(Packet().submessage(0x30, 0, cryptoBody(4, 4))), "");
    EXPECT_NE(faultOf(Packet().submessage(0x32, 0, cryptoFooter(0, 0))), "");
    const Packet part = Packet().submessage(0x0e, 0, Bytes(12)).submessage(0x31, 0, cryptoHeader());
    EXPECT_EQ(
        faultOf(Packet(part).submessage(0x30, 0, cryptoBody(4, 4)).submessage(0x32, 0, cryptoFooter(0, 0))),
        "");
    EXPECT_NE(faultOf(part), "");
    EXPECT_NE(faultOf(Packet(part).submessage(0x31, 0, cryptoHeader())), "");
}

TEST(Datagram, AMillionMutationsNeverReadOutside) {
    // Each in memory of its own size: asan sees what goes beyond.
    std::mt19937 random(7);
    const std::vector<Bytes> seeds = {everything(true).bytes(), everything(false).bytes(),
                                      Packet()
                                          .submessage(0x33, 0, cryptoHeader())
                                          .submessage(0x30, 0, cryptoBody(40, 40))
                                          .submessage(0x34, 0, cryptoFooter(2, 2))
                                          .bytes()};
    Datagram into;
    int refused = 0;
    constexpr int Count = 1'000'000;
    for (int i = 0; i < Count; ++i) {
        Bytes mutated = seeds[random() % seeds.size()];
        for (unsigned change = 1 + random() % 4; change > 0; --change)
            mutated[20 + random() % (mutated.size() - 20)] = static_cast<std::byte>(random());
        if (random() % 4 == 0) mutated.resize(random() % mutated.size());
        mutated.shrink_to_fit();
        if (!parse(mutated, into).empty()) ++refused;
    }
    EXPECT_GT(refused, Count / 4);
    EXPECT_LT(refused, Count);
}

}  // namespace
}  // namespace leitstand::test
