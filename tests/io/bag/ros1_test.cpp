// Bags of ROS 1: their messages as those of ROS 2, whole bags, cut off and damaged ones.
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <bzlib.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4frame.h>

#include "core/io/bag/ros1/message_layout.h"
#include "tests/io/bag/sample_bags.h"
#include "tests/support/temporary_folder.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using detail::Ros1Layout;
using test::opened;
using test::readAll;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string number(std::uint64_t value, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFFU);
    return bytes;
}
template <class Float>
std::string real(Float value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}
std::string text(const std::string& letters) {
    return number(letters.size(), 4) + letters;
}

/// The CDR of @p message behind its encapsulation header; "none" when it does not have this layout.
std::string cdrOf(const std::string& type, const std::string& definition, const std::string& message) {
    const auto layout = Ros1Layout::parse(type, definition);
    if (!layout) return layout.error().text;
    const auto cdr = layout->cdrOf(std::as_bytes(std::span(message.data(), message.size())), 1U << 20U);
    if (!cdr) return "none";
    const std::string bytes(reinterpret_cast<const char*>(cdr->data()), cdr->size());
    EXPECT_EQ(bytes.substr(0, 4), std::string("\0\1\0\0", 4));
    return bytes.substr(4);
}

const std::string Header =
    "\n================================================================================\nMSG: "
    "std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

TEST(Ros1Layout, NumbersAreAlignedAndTextsEndWithAZero) {
    const std::string definition =
        "uint8 a # one\nfloat64 b\nstring c\nint16[] d\nbool[2] e\nuint8 X=3\nstring Y=a = b\n";
    const std::string message = number(7, 1) + real(2.5) + text("ab") + number(2, 4) + number(1, 2) +
                                number(2, 2) + number(1, 1) + number(0, 1);
    EXPECT_EQ(cdrOf("p/T", definition, message), number(7, 1) + std::string(7, '\0') + real(2.5) +
                                                     number(3, 4) + std::string("ab\0", 3) +
                                                     std::string(1, '\0') + number(2, 4) + number(1, 2) +
                                                     number(2, 2) + number(1, 1) + number(0, 1));
}

TEST(Ros1Layout, AHeaderLosesItsCountAndKeepsItsStamp) {
    const std::string message = number(99, 4) + number(5, 4) + number(6, 4) + text("map") + real(1.0F);
    EXPECT_EQ(cdrOf("p/Stamped", "Header header\nfloat32 value\n" + Header, message),
              number(5, 4) + number(6, 4) + number(4, 4) + std::string("map\0", 4) + real(1.0F));
}

TEST(Ros1Layout, TypesOfTheSamePackageNeedNoNameOfIt) {
    const std::string definition = "Point[] points\n====\nMSG: p/Point\nfloat64 x\nfloat32 y\n";
    const std::string message = number(2, 4) + real(1.0) + real(2.0F) + real(3.0) + real(4.0F);
    EXPECT_EQ(cdrOf("p/Line", definition, message), number(2, 4) + std::string(4, '\0') + real(1.0) +
                                                        real(2.0F) + std::string(4, '\0') + real(3.0) +
                                                        real(4.0F));
}

TEST(Ros1Layout, WhatRos2HasBeyondIsFilled) {
    EXPECT_EQ(cdrOf("std_msgs/Empty", "", ""), std::string(1, '\0'));
    const std::string battery =
        cdrOf("sensor_msgs/BatteryState", "float32 voltage\nfloat32 current\n", real(12.0F) + real(1.0F));
    ASSERT_EQ(battery.size(), 12U);
    EXPECT_EQ(battery.substr(0, 4), real(12.0F));
    EXPECT_EQ(battery.substr(8), real(1.0F));
    EXPECT_EQ(detail::ros2TypeOf("sensor_msgs/Imu"), "sensor_msgs/msg/Imu");
    EXPECT_EQ(detail::ros2TypeOf("tf/tfMessage"), "tf2_msgs/msg/TFMessage");
}

TEST(Ros1Layout, AMessageThatDoesNotFitIsNone) {
    const std::string definition = "uint32 a\nstring b\n";
    EXPECT_EQ(cdrOf("p/T", definition, number(1, 4)), "none") << "too short";
    EXPECT_EQ(cdrOf("p/T", definition, number(1, 4) + text("x") + "y"), "none") << "too long";
    EXPECT_EQ(cdrOf("p/T", definition, number(1, 4) + number(0xFFFFFFFF, 4)), "none");
    EXPECT_EQ(cdrOf("p/T", "float64[] a\n", number(0xFFFFFFFF, 4)), "none");
}

TEST(Ros1Layout, HostileTextsNeitherHangNorFill) {
    EXPECT_THAT(cdrOf("p/T", "Missing a\n", ""), HasSubstr("lacks the type p/Missing"));
    EXPECT_THAT(cdrOf("p/T", "T a\n", ""), HasSubstr("lacks the type")) << "within itself";
    EXPECT_THAT(cdrOf("p/T", "uint8[x] a\n", ""), HasSubstr("expected a type"));
    EXPECT_THAT(cdrOf("p/T", std::string(2U << 20U, 'x'), ""), HasSubstr("expected a text of at most"));
    // A chain of types, the last of which comes first: each is known when the one before is looked at.
    std::string first, chain;
    for (int i = 20'000; i > 0; --i) first += "C" + std::to_string(i) + "[] x\n";
    for (int i = 1; i <= 20'000; ++i)
        chain += "==\nMSG: p/C" + std::to_string(i) + "\n" +
                 (i < 20'000 ? "C" + std::to_string(i + 1) + " x\n" : "");
    EXPECT_EQ(cdrOf("p/T", first + "C1 x\n" + chain, std::string(std::size_t{4} * 20'000, '\0')), "none");
    // Ten types that each hold a thousand of the next, and nothing at the end.
    std::string deep = "A0[1000] a\n";
    for (int i = 0; i < 9; ++i)
        deep += "====\nMSG: p/A" + std::to_string(i) + "\nA" + std::to_string(i + 1) + "[1000] a\n";
    EXPECT_EQ(cdrOf("p/T", deep + "====\nMSG: p/A9\n", ""), "none");
    EXPECT_EQ(cdrOf("p/T", "E[] a\n====\nMSG: p/E\n", number(0xFFFFFFFF, 4)), "none");
}

/// Bytes of a bag, put together by hand after https://wiki.ros.org/Bags/Format/2.0.
class Ros1Text {
public:
    using Values = std::map<std::string, std::string>;
    static std::string record(const Values& values, const std::string& data) {
        std::string head;
        for (const auto& [name, value] : values) head += text(name + "=" + value);
        return text(head) + text(data);
    }
    static std::string connection(std::uint32_t id, const std::string& topic,
                                  const std::string& type = "std_msgs/String",
                                  const std::string& definition = "string data\n") {
        std::string data;
        for (const auto& [name, value] :
             Values{{"topic", topic}, {"type", type}, {"md5sum", "*"}, {"message_definition", definition}})
            data += text(name + "=" + value);
        return record({{"op", number(7, 1)}, {"conn", number(id, 4)}, {"topic", topic}}, data);
    }
    static std::string message(std::uint32_t connection, std::uint32_t seconds, const std::string& letters) {
        return record({{"op", number(2, 1)},
                       {"conn", number(connection, 4)},
                       {"time", number(seconds, 4) + number(0, 4)}},
                      text(letters));
    }
    static std::string packed(const std::string& records, const std::string& compression) {
        std::string bytes(records.size() + 10'000, '\0');
        if (compression == "bz2") {
            auto size = static_cast<unsigned>(bytes.size());
            BZ2_bzBuffToBuffCompress(bytes.data(), &size, const_cast<char*>(records.data()),
                                     static_cast<unsigned>(records.size()), 9, 0, 0);
            bytes.resize(size);
            return bytes;
        }
        if (compression == "lz4") {
            bytes.resize(
                LZ4F_compressFrame(bytes.data(), bytes.size(), records.data(), records.size(), nullptr));
            return bytes;
        }
        return records;
    }
    Ros1Text() : m_bytes("#ROSBAG V2.0\n") {
        m_bytes += record({{"op", number(3, 1)},
                           {"index_pos", number(0, 8)},
                           {"conn_count", number(2, 4)},
                           {"chunk_count", number(1, 4)}},
                          std::string(100, ' '));
    }
    Ros1Text& chunk(
        const std::string& records, const std::string& compression = "none",
        const std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::size_t>>>& index = {}) {
        m_bytes +=
            record({{"op", number(5, 1)}, {"compression", compression}, {"size", number(records.size(), 4)}},
                   packed(records, compression));
        for (const auto& [connection, entries] : index) {
            std::string data;
            for (const auto& [seconds, offset] : entries)
                data += number(seconds, 4) + number(0, 4) + number(offset, 4);
            m_bytes += record({{"op", number(4, 1)},
                               {"ver", number(1, 4)},
                               {"conn", number(connection, 4)},
                               {"count", number(entries.size(), 4)}},
                              data);
        }
        return *this;
    }
    /// Appends @p connections, where the index begins.
    Ros1Text& end(const std::string& connections) {
        const std::string name = "index_pos=";
        m_bytes.replace(m_bytes.find(name) + name.size(), 8, number(m_bytes.size(), 8));
        m_bytes += connections;
        return *this;
    }
    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

class Ros1Bag : public testing::Test {
protected:
    static std::vector<std::string> told(const std::vector<RawEvent>& events) {
        std::vector<std::string> all;
        for (const RawEvent& event : events)
            all.push_back(event.topic + " " +
                          std::string(reinterpret_cast<const char*>(event.cdr->data()) + 8));
        return all;
    }
    std::unique_ptr<BagReader> read(const std::string& bytes) const {
        test::writeText(m_file, bytes);
        return opened(m_file);
    }
    const std::string m_connections = Ros1Text::connection(0, "/a") + Ros1Text::connection(7, "b");
    const std::string m_messages = Ros1Text::message(0, 3, "third") + Ros1Text::message(7, 1, "first") +
                                   Ros1Text::message(0, 2, "second");
    const test::TemporaryFolder m_folder;
    const fs::path m_file = m_folder / "walk.bag";
};

TEST_F(Ros1Bag, IsReadByTimeWhateverItsChunksAreCompressedBy) {
    const std::size_t at = m_connections.size(), one = Ros1Text::message(0, 3, "third").size(),
                      two = Ros1Text::message(7, 1, "first").size();
    for (const char* compression : {"none", "bz2", "lz4"}) {
        for (const bool indexed : {true, false}) {
            Ros1Text bag;
            if (indexed)
                bag.chunk(m_connections + m_messages, compression,
                          {{0, {{3, at}, {2, at + one + two}}}, {7, {{1, at + one}}}});
            else
                bag.chunk(m_connections + m_messages, compression);
            const auto reader = read(bag.end(m_connections).bytes());
            ASSERT_NE(reader, nullptr);
            EXPECT_THAT(told(readAll(*reader)), ElementsAre("/b first", "/a second", "/a third"))
                << compression;
            EXPECT_THAT(reader->problems(), IsEmpty()) << compression << indexed;
            EXPECT_EQ(reader->topics().front().info.type, "std_msgs/msg/String");
            EXPECT_EQ(reader->topics().front().messages, 2U);
            EXPECT_TRUE(reader->sessions().front().closed);
            EXPECT_EQ(reader->first(), Time(std::chrono::seconds(1)));
        }
    }
}

TEST_F(Ros1Bag, OneThatIsCutOffIsReadAsFarAsItGoes) {
    const std::size_t at = m_connections.size(), one = Ros1Text::message(0, 3, "third").size(),
                      two = Ros1Text::message(7, 1, "first").size();
    const std::string first =
        Ros1Text().chunk(m_connections + m_messages, "lz4").bytes();  // without its indexes
    const std::string whole = Ros1Text()
                                  .chunk(m_connections + m_messages, "lz4",
                                         {{0, {{3, at}, {2, at + one + two}}}, {7, {{1, at + one}}}})
                                  .chunk(m_messages)
                                  .bytes();
    for (std::size_t size = 13; size < whole.size(); ++size) {
        const auto reader = read(whole.substr(0, size));
        ASSERT_NE(reader, nullptr) << size;
        const auto events = readAll(*reader);
        if (size >= first.size()) {
            EXPECT_GE(events.size(), 3U) << size;
        }
    }
}

TEST_F(Ros1Bag, DamageAndHostileNumbersAreNamed) {
    const auto problemsOf = [&](const std::string& bytes) {
        const auto reader = read(bytes);
        (void)readAll(*reader);
        return reader->problems();
    };
    EXPECT_THAT(problemsOf(Ros1Text().chunk(m_connections + m_messages, "snappy").bytes()),
                Contains(HasSubstr("found \"snappy\"")));
    std::string damaged = Ros1Text().chunk(m_connections + m_messages, "bz2").bytes();
    damaged[damaged.size() / 2 + 60] = static_cast<char>(damaged[damaged.size() / 2 + 60] ^ 0x55);
    EXPECT_THAT(problemsOf(damaged), testing::Not(IsEmpty()));
    EXPECT_THAT(problemsOf(Ros1Text()
                               .chunk(m_connections + m_messages, "none", {{0, {{1, 5}, {1, 0xFFFFFFFF}}}})
                               .end(m_connections)
                               .bytes()),
                Contains(HasSubstr("expected a message where the index says")));
    EXPECT_THAT(problemsOf("#ROSBAG V2.0\n" + number(0xFFFFFFFF, 4)),
                Contains(HasSubstr("ends within this record")));
    EXPECT_THAT(
        problemsOf(
            Ros1Text().chunk(Ros1Text::connection(0, "/x", "p/T", "Missing m\n") + m_messages).bytes()),
        Contains(HasSubstr("/x: p/T: its text lacks the type")));
}

TEST_F(Ros1Bag, IsOpenedInAFolderToo) {
    const fs::path folder = m_folder / "walk";
    fs::create_directory(folder);
    test::writeText(folder / "walk_0.bag", Ros1Text().chunk(m_connections + m_messages).bytes());
    const auto reader = opened(folder);
    ASSERT_NE(reader, nullptr);
    EXPECT_EQ(readAll(*reader).size(), 3U);
}

TEST_F(Ros1Bag, AnotherFormatIsSaid) {
    test::writeText(m_file, "#ROSBAG V1.2\n");
    const auto reader = BagReader::open(m_file);
    ASSERT_FALSE(reader);
    EXPECT_THAT(reader.error().text, HasSubstr("walk.bag: expected a bag of ROS 1 in format 2.0"));
}

}  // namespace
}  // namespace leitstand
