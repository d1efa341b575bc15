#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(KeysCommand, MakesAndShowsIdentities) {
    const TemporaryFolder folder;
    const std::string store = (folder / "keys").string();
    const auto made =
        runProcess(program("leitstandctl"), {"keys", "--out", store, "--station", "station1", "--robot",
                                             "kurt3d", "crawler", "--viewer", "coach", "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(json::parse(made.out)["identities"].size(), 4u);
    const auto added = runProcess(program("leitstandctl"),
                                  {"keys", "--out", store, "--robot", "burger", "--allow", "burger=rt/scan"});
    ASSERT_EQ(added.exitCode, 0) << added.err;
    EXPECT_THAT(readText(folder / "keys/enclaves/burger/permissions.xml"),
                HasSubstr("<topic>rt/scan</topic>"));
    const auto shown = runProcess(program("leitstandctl"), {"keys", "show", store, "--json"});
    ASSERT_EQ(shown.exitCode, 0) << shown.err;
    const json identities = json::parse(shown.out)["identities"];
    ASSERT_EQ(identities.size(), 5u);
    EXPECT_EQ(identities[0]["name"], "burger");
    EXPECT_EQ(identities[0]["role"], "robot");
    EXPECT_TRUE(identities[0]["problem"].is_null());
    EXPECT_THAT(runProcess(program("leitstandctl"), {"keys", "show", store}).out, HasSubstr("station1"));
}

TEST(KeysCommand, RefusesToOverwriteAndRenewsAndRevokes) {
    const TemporaryFolder folder;
    const std::string store = (folder / "keys").string();
    ASSERT_EQ(runProcess(program("leitstandctl"), {"keys", "--out", store, "--robot", "kurt3d"}).exitCode, 0);
    const auto again = runProcess(program("leitstandctl"), {"keys", "--out", store, "--robot", "kurt3d"});
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_THAT(again.err, HasSubstr("never overwritten"));
    EXPECT_EQ(runProcess(program("leitstandctl"), {"keys", "--out", store, "--robot", "kurt3d", "--renew"})
                  .exitCode,
              0);
    const auto revoked = runProcess(program("leitstandctl"), {"keys", "--out", store, "--revoke", "kurt3d"});
    EXPECT_EQ(revoked.exitCode, 0) << revoked.err;
    EXPECT_THAT(revoked.err, HasSubstr("2 certificate(s) revoked"));
    EXPECT_EQ(runProcess(program("leitstandctl"), {"keys", "show", store}).exitCode, 0);
}

TEST(KeysCommand, KnowsBadUsage) {
    const TemporaryFolder folder;
    const std::string store = (folder / "keys").string();
    EXPECT_EQ(runProcess(program("leitstandctl"), {"keys"}).exitCode, 2);
    EXPECT_EQ(runProcess(program("leitstandctl"), {"keys", "--out", store}).exitCode, 2);
    EXPECT_EQ(runProcess(program("leitstandctl"), {"keys", "show"}).exitCode, 2);
    EXPECT_EQ(
        runProcess(program("leitstandctl"), {"keys", "--out", store, "--robot", "a", "--allow", "b=rt/x"})
            .exitCode,
        2);
    const auto odd = runProcess(program("leitstandctl"), {"keys", "--out", store, "--robot", "kurt 3d"});
    EXPECT_EQ(odd.exitCode, 1);
    EXPECT_THAT(odd.err, HasSubstr("kurt 3d"));
    EXPECT_EQ(runProcess(program("leitstandctl"), {"keys", "show", store}).exitCode, 1);
    EXPECT_FALSE(std::filesystem::exists(folder / "keys"));
}

}  // namespace
}  // namespace leitstand::test
