#include "transport/security/permissions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string permissionsOf(const KeyRequest& request) {
    return permissionsXml(request, "CN=a,O=b", Time(std::chrono::hours(48)), Time(std::chrono::hours(96)));
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const auto start = text.find(from);
    if (start == std::string::npos) return {};
    return text.substr(start, text.find(to, start) - start);
}

TEST(Permissions, EscapeWhatXmlWouldRead) {
    EXPECT_EQ(xmlEscaped("<a & \"b\">'\n"), "&lt;a &amp; &quot;b&quot;&gt;&apos;");
    const std::string text =
        permissionsXml({KeyRole::Viewer, "v", {}, false}, "CN=</subject_name>&,O=b", Time{}, Time{});
    EXPECT_THAT(text, HasSubstr("<subject_name>CN=&lt;/subject_name&gt;&amp;,O=b</subject_name>"));
}

TEST(Permissions, OfAStationCommandAllRobotsButSayNothingForThem) {
    const std::string publish =
        between(permissionsOf({KeyRole::Station, "s", {}, false}), "<publish>", "</pub");
    EXPECT_THAT(publish, HasSubstr("<topic>rt/*/cmd_vel</topic>"));
    EXPECT_THAT(publish, HasSubstr("<topic>rq/*</topic>")) << "requests of services";
    EXPECT_THAT(publish, HasSubstr("<topic>rt/*/stop_cmd</topic>"));
    EXPECT_THAT(publish, HasSubstr("<topic>rt/leitstand/*</topic>"));
    EXPECT_THAT(publish, Not(HasSubstr("<topic>rt/*</topic>")));
}

TEST(Permissions, OfAViewerStopButNotDrive) {
    const std::string publish =
        between(permissionsOf({KeyRole::Viewer, "v", {}, false}), "<publish>", "</pub");
    EXPECT_THAT(publish, HasSubstr("<topic>rt/*/stop_cmd</topic>"));
    EXPECT_THAT(publish, HasSubstr("<topic>rt/*/ping</topic>"));
    EXPECT_THAT(publish, Not(HasSubstr("cmd_vel")));
    EXPECT_THAT(publish, Not(HasSubstr("rq/")));
    EXPECT_THAT(publish, Not(HasSubstr("leitstand")));
}

TEST(Permissions, OfARobotCoverItsOwnTopicsOnly) {
    const std::string text = permissionsOf({KeyRole::Robot, "kurt3d", {"rt/scan"}, false});
    const std::string forbidden = between(text, "<deny_rule>", "</deny_rule>");
    EXPECT_THAT(forbidden, HasSubstr("<topic>rt/kurt3d/cmd_vel</topic>"));
    const std::string publish = between(between(text, "<allow_rule>", "</allow_rule>"), "<publish>", "</pub");
    EXPECT_THAT(publish, HasSubstr("<topic>rt/kurt3d/*</topic>"));
    EXPECT_THAT(publish, HasSubstr("<topic>rt/scan</topic>"));
    EXPECT_THAT(publish, Not(HasSubstr("<topic>rt/*")));
    EXPECT_THAT(permissionsOf({KeyRole::Robot, "kurt3d", {}, true}), Not(HasSubstr("deny_rule")));
}

TEST(Permissions, AreADayWiderThanTheCertificate) {
    const std::string text = permissionsOf({KeyRole::Viewer, "v", {}, false});
    EXPECT_THAT(text, HasSubstr("<not_before>1970-01-02T00:00:00</not_before>"));
    EXPECT_THAT(text, HasSubstr("<not_after>1970-01-06T00:00:00</not_after>"));
}

TEST(Governance, LetsNobodyInWithoutAnIdentityAndEncrypts) {
    const std::string text = governanceXml();
    EXPECT_THAT(text, HasSubstr("<allow_unauthenticated_participants>false<"));
    EXPECT_THAT(text, HasSubstr("<enable_join_access_control>true<"));
    EXPECT_THAT(text, HasSubstr("<discovery_protection_kind>ENCRYPT<"));
    EXPECT_THAT(text, HasSubstr("<liveliness_protection_kind>ENCRYPT<"));
    EXPECT_THAT(text, HasSubstr("<rtps_protection_kind>ENCRYPT<"));
    EXPECT_LT(text.find("rt/*/cmd_vel"), text.find("<topic_expression>*<")) << "the first rule decides";
}

}  // namespace
}  // namespace leitstand::test
