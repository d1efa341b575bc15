#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "messages/diagnostic_msgs.h"
#include "messages/leitstand_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/tf2_msgs.h"
#include "tests/transport/convert/allocations.h"
#include "tests/transport/convert/conversion.h"

namespace leitstand::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Nothing that a sample says may cost more than its own size justifies.
std::size_t mostBytes(std::size_t size) {
    return 20'000 + 32 * size;
}

/// Decodes; what comes out must be encodable again, errors must say where they come from.
void decodeHostile(const SampleCase& one, std::vector<std::byte> bytes) {
    const RawEvent event = rawEvent(one, std::move(bytes));
    allocatedBytes = 0;
    const auto sample = decodeCase(one, event);
    ASSERT_LE(allocatedBytes.load(), mostBytes(event.cdr->size())) << one.type;
    if (!sample) {
        ASSERT_THAT(sample.error().text, AllOf(HasSubstr(event.topic), HasSubstr(one.type)));
    }
}

TEST(Hostile, SamplesThatEndEarlyAreRefused) {
    for (const SampleCase& one : sampleCases()) {
        const auto bytes = encoded(one);
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            const std::vector<std::byte> cut(bytes.begin(),
                                             bytes.begin() + static_cast<std::ptrdiff_t>(size));
            const auto sample = decodeCase(one, rawEvent(one, cut));
            ASSERT_FALSE(sample) << one.type << " of " << size << " bytes";
        }
    }
}

TEST(Hostile, SamplesThatGoOnAreRefused) {
    for (const SampleCase& one : sampleCases()) {
        auto bytes = encoded(one);
        bytes.resize(bytes.size() + 3);
        EXPECT_TRUE(decodeCase(one, rawEvent(one, bytes))) << one.type << ": padding is no fault";
        bytes.resize(bytes.size() + 64);
        EXPECT_FALSE(decodeCase(one, rawEvent(one, bytes))) << one.type;
    }
}

TEST(Hostile, FlippedBytesNeverHarm) {
    std::mt19937 random(1);
    for (const SampleCase& one : sampleCases()) {
        const auto bytes = encoded(one);
        std::uniform_int_distribution<std::size_t> place(0, bytes.size() - 1);
        std::uniform_int_distribution<int> value(0, 255), flips(1, 4);
        for (int i = 0; i < 2'000; ++i) {
            auto hostile = bytes;
            for (int flip = flips(random); flip > 0; --flip) {
                hostile[place(random)] = static_cast<std::byte>(value(random));
            }
            ASSERT_NO_FATAL_FAILURE(decodeHostile(one, std::move(hostile)));
        }
    }
}

TEST(Hostile, CountsThatLieNeverHarm) {
    for (const SampleCase& one : sampleCases()) {
        const auto bytes = encoded(one);
        for (std::size_t at = 4; at + 4 <= bytes.size(); ++at) {
            for (const int value : {0xff, 0x7f, 0x00}) {
                auto hostile = bytes;
                std::fill_n(hostile.begin() + static_cast<std::ptrdiff_t>(at), 4,
                            static_cast<std::byte>(value));
                ASSERT_NO_FATAL_FAILURE(decodeHostile(one, std::move(hostile)));
            }
        }
    }
}

TEST(Hostile, GarbageNeverHarms) {
    std::mt19937 random(2);
    std::uniform_int_distribution<int> value(0, 255);
    std::uniform_int_distribution<std::size_t> size(0, 600);
    for (const SampleCase& one : sampleCases()) {
        for (int i = 0; i < 500; ++i) {
            std::vector<std::byte> garbage(size(random));
            for (std::byte& byte : garbage) byte = static_cast<std::byte>(value(random));
            const std::byte header[] = {std::byte{0}, static_cast<std::byte>(i % 2), std::byte{0},
                                        std::byte{0}};
            if (garbage.size() >= 4) std::copy(std::begin(header), std::end(header), garbage.begin());
            ASSERT_NO_FATAL_FAILURE(decodeHostile(one, std::move(garbage)));
        }
    }
}

/// Decodes a message that @p fill made long, its cost measured.
template <class Message, class Fill>
void decodeLong(StreamRole role, Fill fill) {
    Message message;
    fill(message);
    CdrWriter out;
    encode(out, message);
    const SampleCase one{Message::RosName, role, {}};
    decodeHostile(one, std::move(out).finish());
}

TEST(Hostile, SequencesOfTheShortestElementsCostNoMoreThanOthers) {
    using namespace wire;
    for (const std::size_t count : {1'000u, 100'000u, 1'000'000u}) {
        decodeLong<sensor_msgs::JointState>(StreamRole::Joints, [&](auto& m) { m.name.resize(count); });
        decodeLong<diagnostic_msgs::DiagnosticArray>(StreamRole::Diagnostics,
                                                     [&](auto& m) { m.status.resize(count); });
        decodeLong<tf2_msgs::TFMessage>(StreamRole::Transforms, [&](auto& m) { m.transforms.resize(count); });
        decodeLong<sensor_msgs::PointCloud2>(StreamRole::Points, [&](auto& m) { m.fields.resize(count); });
        decodeLong<leitstand_msgs::Bumps>(StreamRole::Bumps, [&](auto& m) { m.bumpers.resize(count); });
    }
    sensor_msgs::JointState message;
    message.name.resize(100'001);
    CdrWriter out;
    encode(out, message);
    const SampleCase one{message.RosName, StreamRole::Joints, {}};
    EXPECT_THAT(decodeCase(one, rawEvent(one, std::move(out).finish())).error().text,
                HasSubstr("name: expected at most 100000 elements, found 100001"));
}

TEST(Hostile, OtherRepresentationsAndTypesAreRefusedWithWords) {
    const SampleCase one = sampleCases().front();
    auto bytes = encoded(one);
    bytes[1] = std::byte{3};  // PL_CDR
    EXPECT_THAT(decodeCase(one, rawEvent(one, bytes)).error().text, HasSubstr("plain XCDR1"));
    RawEvent event = rawEvent(one, encoded(one));
    event.type = "nav_msgs/msg/Odometry";
    EXPECT_THAT(decode(event, one.stream()).error().text,
                AllOf(HasSubstr("expected sensor_msgs/msg/PointCloud2"), HasSubstr("points")));
    EXPECT_THAT(decodeStationEvent(event).error().text, HasSubstr("leitstand_msgs/msg/Victim"));
    event.cdr = nullptr;
    EXPECT_FALSE(decode(event, one.stream()));
}

}  // namespace
}  // namespace leitstand::test
