#include "core/robot/link/link_reasons.h"

#include <gtest/gtest.h>

#include "core/event/stream_role.h"

namespace leitstand {
namespace {

using Kind = LinkReason::Kind;

TEST(LinkReasons, AreReadAgainAsTheyWereSaid) {
    for (const Kind kind : {Kind::Stale, Kind::Late, Kind::Loss}) {
        for (const StreamRole role : allStreamRoles()) {
            for (const std::string sensor : {"", "left", "mast camera"}) {
                const LinkReason reason{kind, 0.25, role, sensor};
                // Logs of before have the sentence.
                for (const std::string& text : {toString(reason), logged(reason)}) {
                    const auto read = linkReasonFrom(text);
                    ASSERT_TRUE(read) << text;
                    EXPECT_EQ(toString(*read), toString(reason));
                    EXPECT_EQ(read->kind, kind);
                    EXPECT_EQ(read->role, role);
                }
            }
        }
    }
    for (const Kind kind : {Kind::Silent, Kind::Slow, Kind::NoAnswer}) {
        const LinkReason reason{kind, 3.5};
        for (const std::string& text : {toString(reason), logged(reason)}) {
            const auto read = linkReasonFrom(text);
            ASSERT_TRUE(read) << text;
            EXPECT_EQ(read->kind, kind);
            EXPECT_DOUBLE_EQ(read->value, 3.5);
        }
    }
}

TEST(LinkReasons, OthersAreNone) {
    for (const char* reported :
         {"", "degraded", "odometry old", "odometry x s old", "12 % of  lost", " 1.0 s old",
          "12 % of tea lost", "round trip nan ms", "round trip inf ms", "tea 1.0 s late",
          "no answer to pings for 1e999 s", "leftpictures 1.0 s old", "slow", "slow round_trip_ms=nan",
          "stale seconds=1", "stale stream=tea seconds=1", "late stream=imu seconds=\"1"})
        EXPECT_FALSE(linkReasonFrom(reported)) << reported;
}

}  // namespace
}  // namespace leitstand
