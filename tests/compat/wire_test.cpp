// What robots and other programs rely on: types, topics and quality of service of streams, and hashes of
// messages.
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/stream_role.h"
#include "core/io/bag/topic_info.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"
#include "tests/compat/expected.h"
#include "tests/compat/lines.h"
#include "transport/convert/message_catalog.h"

namespace leitstand::test {
namespace {

/// Streams as robots have them whose files say nothing else.
TEST(CompatWire, StreamsHaveTheirTopicsTypesAndQuality) {
    std::vector<std::string> lines;
    for (const StreamRole role : allStreamRoles()) {
        const StreamDescription stream =
            defaultStream(role, "ROBOT", streamFacts(role).ofCamera ? "CAMERA" : "");
        std::string line = toString(role) + (isCommand(role) ? " to " : " from ") + stream.topic;
        for (const std::string_view type : typesOf(role)) line += ' ' + std::string(type);
        line += stream.qos.reliability == Qos::Reliability::Reliable ? " reliable" : " best_effort";
        line += stream.qos.durability == Qos::Durability::TransientLocal ? " transient_local" : " volatile";
        line += " depth " + std::to_string(stream.qos.depth) + " lifespan " +
                std::to_string(stream.qos.lifespan) + " deadline " + std::to_string(stream.qos.deadline);
        lines.push_back(line);
    }
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    (void)isAsExpected("wire-streams.txt", text);
    EXPECT_THAT(goneFrom("wire-streams.txt", lines), testing::IsEmpty())
        << "changed; new ones are added to the list";
}

TEST(CompatWire, MessagesHaveTheirHashes) {
    std::vector<std::string> lines;
    std::string text;
    for (const MessageType& type : messageTypes()) {
        lines.push_back(std::string(type.rosName) + ' ' + std::string(type.hash));
        text += lines.back() + '\n';
    }
    (void)isAsExpected("wire-messages.txt", text);
    EXPECT_THAT(goneFrom("wire-messages.txt", lines), testing::IsEmpty())
        << "changed; new ones are added to the list";
}

}  // namespace
}  // namespace leitstand::test
