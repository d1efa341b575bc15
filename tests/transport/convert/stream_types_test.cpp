#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/raw_event.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

TEST(StreamTypes, AreUnderstood) {
    for (const StreamFacts& row : streamTable()) {
        StreamDescription stream;
        stream.role = row.role;
        for (const std::string_view type : row.types) {
            RawEvent event;
            event.topic = "/rover/topic";
            event.type = std::string(type);
            event.cdr = std::make_shared<const std::vector<std::byte>>();
            EXPECT_THAT(decode(event, stream).error().text, testing::HasSubstr("encapsulation"))
                << toString(row.role) << ": nothing decodes " << type;
        }
    }
}

}  // namespace
}  // namespace leitstand::test
