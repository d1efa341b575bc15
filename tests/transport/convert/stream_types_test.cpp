#include "core/robot/streams/stream_types.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

/// Robot files allow what can be decoded, no less and no more.
TEST(StreamTypes, AreThoseThatAreUnderstood) {
    for (const StreamRole role : allStreamRoles()) {
        const auto types = typesOf(role);
        EXPECT_THAT(typesFor(role), testing::UnorderedElementsAreArray(types.begin(), types.end()))
            << toString(role);
    }
}

}  // namespace
}  // namespace leitstand::test
