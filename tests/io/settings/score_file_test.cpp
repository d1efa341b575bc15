#include "core/io/settings/score_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/mission/score/score.h"
#include "core/mission/state/find_state.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

const char* const Least = R"({"name": "x", "version": "2", "points": {"location": 10}})";

TEST(ScoreFile, ReadsWhatItNamesAndKeepsTheRest) {
    const auto profile = parseScoreProfile(
        R"({"name": "x", "version": "2", "areas": {"red": 2.5}, "points": {"location": 10, "co2": 1},
            "operators": "count", "unconfirmed": ["points"]})",
        "x.json");
    ASSERT_TRUE(profile) << profile.error().text;
    EXPECT_EQ(profile->title, "x");
    EXPECT_EQ(profile->areas.at("red"), 2.5);
    EXPECT_EQ(profile->points.at(ScoreItem::Co2), 1.0);
    EXPECT_FALSE(profile->points.contains(ScoreItem::Map));
    EXPECT_EQ(profile->operators, OperatorRule::Count);
    EXPECT_EQ(profile->autonomous, 1.0);
    EXPECT_EQ(profile->unconfirmed, std::vector<std::string>{"points"});
}

TEST(ScoreFile, TellsWhichCodesAreTagsOfVictims) {
    const auto tags = [](const std::string& more) {
        const auto profile =
            parseScoreProfile(R"({"name": "x", "version": "2", "points": {})" + more + "}", "x.json");
        return profile ? profile->victimTags : TagPatterns{profile.error().text};
    };
    EXPECT_EQ(tags(R"(, "victim_tags": ["doll-*"])"), TagPatterns{"doll-*"});
    EXPECT_EQ(tags(R"(, "victim_tags": [])"), TagPatterns());
    EXPECT_EQ(tags(""), usualTags());
}

TEST(ScoreFile, MistakesAreToldWithTheirPlace) {
    const auto error = [](const std::string& text) {
        const auto profile = parseScoreProfile(text, "x.json");
        return profile ? std::string("none") : profile.error().text;
    };
    EXPECT_THAT(error("{}"), HasSubstr("name"));
    EXPECT_THAT(error(R"({"name": "x", "version": "1",
 "points": {"locatoin": 1}})"),
                HasSubstr("x.json:2"));
    EXPECT_THAT(error(R"({"name": "x", "version": "1", "points": {"map": -1}})"), HasSubstr("map"));
    EXPECT_THAT(error(R"({"name": "x", "version": "1", "points": {"map": NaN}})"), HasSubstr("map"));
    EXPECT_THAT(error(R"({"name": "x", "version": "1", "points": {"map": 1e300}})"), HasSubstr("map"));
    EXPECT_THAT(error(R"({"name": "x", "version": "1", "points": {}, "operators": "some"})"),
                HasSubstr("operators"));
    EXPECT_THAT(error(R"({"name": "x", "version": "1", "points": {}, "unconfirmed": [{"a": 1}]})"),
                HasSubstr("unconfirmed"));
    const auto tags = [&](const std::string& list) {
        return error(R"({"name": "x", "version": "1", "points": {}, "victim_tags": )" + list + "}");
    };
    EXPECT_EQ(tags(R"(["V-*", "doll ##"])"), "none");
    for (const char* list : {R"([""])", R"([["V"]])", R"([{"a": 1}])"})
        EXPECT_THAT(tags(list), HasSubstr("victim_tags")) << list;
    EXPECT_THAT(tags("[\"" + std::string(65, 'V') + "\"]"), HasSubstr("victim_tags"));
    EXPECT_NE(error(std::string(Least).substr(0, 30)), "none");
    EXPECT_NE(error(std::string(1'000'000, '[')), "none");
    EXPECT_NE(error(std::string("\0\x01\xff", 3)), "none");
}

TEST(ScoreFile, ShippedProfilesAreReadAndTellWhatIsUnconfirmed) {
    const auto all = scoreProfilesIn({std::filesystem::path(sourceFolder()) / "resources/scoring"});
    EXPECT_THAT(all.problems, testing::IsEmpty());
    ASSERT_EQ(all.profiles.size(), 3U);
    const ScoreProfile& old = *all.find("2005");
    double most = 0.0;
    for (const auto& [item, points] : old.points) most += points;
    EXPECT_EQ(most, 50.0) << "of a victim, as the rules of 2005 are known";
    EXPECT_EQ(old.areas.at("orange"), 0.75);
    EXPECT_EQ(all.find("2019")->autonomous, 2.0);
    EXPECT_EQ(all.find("none such")->name, "2019") << "the newest";
    for (const ScoreProfile& profile : all.profiles) {
        // What no readable source has, whether the file tells a value or leaves it at nothing.
        for (const char* value : {"areas", "points", "area_bump", "victim_bump", "operators"})
            EXPECT_THAT(profile.unconfirmed, testing::Contains(value)) << profile.name;
    }
    EXPECT_EQ(all.find("2013")->minutes, 20.0);
    EXPECT_EQ(all.find("2019")->minutes, 23.0);
    EXPECT_EQ(all.find("2019")->semiAutonomous, 1.5);
}

/// A victim that is told whole, one without signs of life, a robot's own find of which half is told, one that
/// nobody confirmed.
MissionState fourVictims() {
    using Sign = VictimSign::State;
    MissionState state;
    std::vector<FindSample> victims(4);
    for (std::uint32_t i = 0; i < 4; ++i) {
        victims[i].number = i + 1;
        victims[i].status = FindSample::Status::Confirmed;
        victims[i].positionInMap = {1.0 + i, 2.0, 0.3};
        victims[i].area = i == 1 ? "orange" : "yellow";
        victims[i].situation = "void";
    }
    for (VictimSign* sign : {&victims[0].form, &victims[0].motion, &victims[0].heat, &victims[0].sound,
                             &victims[0].co2, &victims[2].heat})
        sign->state = Sign::Present;
    victims[2].co2.state = Sign::Absent;
    victims[0].tag = victims[2].tag = "R-17";
    victims[2].autonomous = true;
    victims[3].status = FindSample::Status::Hypothesis;
    for (const FindSample& victim : victims)
        state.finds.edit()[{victim.kind, victim.number}] = {victim.number, victim.number, victim};
    return state;
}

TEST(ScoreFile, TheItemsOfAVictimMakeItsPointsByEveryShippedProfile) {
    const auto all = scoreProfilesIn({std::filesystem::path(sourceFolder()) / "resources/scoring"});
    for (const ScoreProfile& profile : all.profiles) {
        const ScoreResult result = score(profile, fourVictims());
        ASSERT_EQ(result.finds.size(), 4U) << profile.name;
        for (const ScoredFind& find : result.finds) {
            double sum = 0.0;
            for (const ScoredItem& item : find.items) {
                sum += item.points;
                EXPECT_TRUE(item.points == 0.0 || item.points == item.possible)
                    << profile.name << ", " << find.name << ": " << toString(item.item);
            }
            EXPECT_EQ(find.items.size(), profile.points.size()) << profile.name << ", " << find.name;
            EXPECT_DOUBLE_EQ(sum, find.points) << profile.name << ", " << find.name;
            EXPECT_DOUBLE_EQ(find.total, find.confirmed ? sum * find.weight * find.factor : 0.0)
                << profile.name << ", " << find.name;
        }
        EXPECT_GT(result.finds[0].points, result.finds[2].points) << profile.name;
        EXPECT_GT(result.finds[2].points, result.finds[1].points) << profile.name;
    }
}

TEST(ScoreFile, TheUsersProfileReplacesTheShippedAndABrokenOneIsTold) {
    const TemporaryFolder shipped, own;
    std::ofstream(shipped / "x.json") << Least;
    std::ofstream(own / "mine.json") << R"({"name": "x", "version": "3", "points": {}})";
    std::ofstream(own / "bad.json") << "{";
    const auto all = scoreProfilesIn({shipped / ".", own / ".", own / "missing"});
    ASSERT_EQ(all.profiles.size(), 1U);
    EXPECT_EQ(all.profiles[0].version, "3");
    ASSERT_EQ(all.problems.size(), 1U);
    EXPECT_THAT(all.problems[0], HasSubstr("bad.json"));
    EXPECT_FALSE(readScoreProfile(own / "missing.json"));
}

}  // namespace
}  // namespace leitstand::test
