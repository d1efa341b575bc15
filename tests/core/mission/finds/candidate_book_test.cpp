#include "core/mission/finds/candidate_book.h"

#include <chrono>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using Kind = FindSample::Kind;

Time at(double seconds) {
    return Time(std::chrono::milliseconds(1'000'000 + static_cast<int>(1000.0 * seconds)));
}

struct Seen {
    std::string kind = "heat";
    Eigen::Vector3d place = {2, 1, 0.2};
    double confidence = 0.9;
    std::string text = {};
    std::string robot = "kurt3d";
    std::uint64_t scan = 0;
    double deviation = 0.08;
    Eigen::Vector3d from = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

PlacedCue cueOf(const Seen& seen) {
    PlacedCue cue;
    cue.cue.kind = seen.kind;
    cue.cue.robot = seen.robot;
    cue.cue.confidence = seen.confidence;
    cue.cue.text = seen.text;
    cue.what = seen.kind == "code" ? Kind::Code : seen.kind == "hazard" ? Kind::Hazard : Kind::Victim;
    cue.inMap = seen.place;
    cue.from = seen.from;
    cue.covariance = seen.deviation * seen.deviation * Eigen::Matrix3d::Identity();
    cue.reach = seen.kind == "co2" ? 1.5 : 0.0;
    cue.scan = seen.scan;
    return cue;
}

/// A book, and the newest that it told of each candidate.
class Reader {
public:
    void see(const Seen& seen, int times = 8) {
        for (int i = 0; i < times; ++i) {
            PlacedCue cue = cueOf(seen);
            cue.cue.stamp = at(m_time);
            book.add(cue);
            look(0.5);
        }
    }
    void look(double seconds) {
        m_time += seconds;
        for (const CandidateSample& one : book.due(at(m_time))) {
            published[one.id] = one;
            ++updates;
        }
    }
    [[nodiscard]] std::vector<CandidateSample> standing() const {
        std::vector<CandidateSample> list;
        for (const auto& [id, one] : published) {
            if (!one.dismissed) list.push_back(one);
        }
        return list;
    }
    CandidateBook book{"us"};
    std::map<std::uint32_t, CandidateSample> published;
    int updates = 0;

private:
    double m_time = 0.0;
};

TEST(CandidateBook, APersonsHeatIsACandidateAndALampsIsNone) {
    Reader reader;
    reader.see({.place = {5, 5, 0.3}, .confidence = 0.3});
    reader.look(2.0);
    EXPECT_TRUE(reader.published.empty());
    reader.see({.place = {2, 1, 0.2}});
    reader.look(2.0);
    ASSERT_EQ(reader.standing().size(), 1U);
    EXPECT_LT((reader.published[1].positionInMap - Eigen::Vector3d(2, 1, 0.2)).norm(), 1e-6);
    EXPECT_GT(reader.published[1].confidence, 0.6);
    EXPECT_EQ(reader.published[1].station, "us");
}

TEST(CandidateBook, AgreeingKindsMakeItSure) {
    Reader reader;
    reader.see({.confidence = 0.45});
    EXPECT_TRUE(reader.published.empty()) << "it could be a lamp";
    reader.see({.kind = "co2", .place = {1, 1, 0.3}, .confidence = 0.9});
    reader.see({.kind = "motion", .place = {2.2, 1, 0.3}, .confidence = 0.7});
    reader.look(2.0);
    ASSERT_EQ(reader.standing().size(), 1U);
    EXPECT_GT(reader.published[1].confidence, 0.75);
    EXPECT_EQ(reader.published[1].cues.size(), 3U);
}

TEST(CandidateBook, BreathSupportsTheLikeliestNearbyAlone) {
    Reader reader;
    reader.see({.place = {2, 1, 0.2}, .confidence = 0.9});
    reader.see({.place = {3.2, 1, 0.2}, .confidence = 0.25});
    reader.see({.kind = "co2", .place = {2.6, 0, 0.3}, .confidence = 1.0}, 20);
    reader.look(2.0);
    EXPECT_EQ(reader.standing().size(), 1U) << "a lamp does not breathe";
    EXPECT_NEAR(reader.published[1].positionInMap.x(), 2.0, 0.01) << "where it breathes is not where it lies";
}

TEST(CandidateBook, ALampStaysOneWhereSomebodyBreathes) {
    Reader reader;
    reader.see({.place = {3, 1, 0.3}, .confidence = 0.25}, 20);
    reader.see({.kind = "sighting", .place = {3, 1, 0}, .confidence = 0.4, .text = "victim 1"}, 1);
    reader.see({.kind = "co2", .place = {3, 0, 0.3}, .confidence = 1.0}, 20);
    reader.look(2.0);
    EXPECT_TRUE(reader.standing().empty());
}

TEST(CandidateBook, AGlimpseIsNotEnough) {
    Reader reader;
    reader.see({}, 2);
    for (int i = 0; i < 20; ++i) reader.book.add(cueOf({}));  // at one moment
    reader.look(2.0);
    EXPECT_TRUE(reader.standing().empty());
}

TEST(CandidateBook, ViewsRobotsAndPartsOfABodyAreJoined) {
    Reader reader;
    reader.see({.place = {2.0, 1.0, 0.2}, .scan = 1});
    reader.see({.place = {2.3, 1.1, 0.1}, .scan = 2});
    reader.see({.place = {2.1, 0.8, 0.2}, .robot = "crawler", .scan = 3, .deviation = 0.2});
    reader.look(2.0);
    ASSERT_EQ(reader.standing().size(), 1U);
    EXPECT_NEAR(reader.published[1].positionInMap.x(), 2.14, 0.08);
    EXPECT_LT(reader.published[1].deviation, 0.12);
    reader.see({.place = {3.4, 1.0, 0.2}});
    EXPECT_EQ(reader.standing().size(), 2U) << "another one";
}

TEST(CandidateBook, AWrongRangeIsOutvoted) {
    Reader reader;
    for (std::uint64_t scan = 1; scan <= 4; ++scan)
        reader.see({.place = {2.0 + 0.02 * static_cast<double>(scan), 1.0, 0.2}, .scan = scan});
    reader.see({.place = {2.6, 1.0, 0.2}, .scan = 5});
    reader.look(2.0);
    ASSERT_EQ(reader.standing().size(), 1U);
    EXPECT_NEAR(reader.published[1].positionInMap.x(), 2.05, 0.09);
}

TEST(CandidateBook, ARobotsOwnSightingIsNoSecondOpinionAndNeverDoubled) {
    Reader reader;
    reader.see({.confidence = 0.95});
    reader.look(2.0);
    const double before = reader.published.at(1).confidence;
    for (int i = 0; i < 20; ++i)
        reader.see({.kind = "sighting", .place = {2.1, 1, 0}, .confidence = 0.9, .text = "victim 3"}, 1);
    reader.look(2.0);
    ASSERT_EQ(reader.standing().size(), 1U);
    EXPECT_NEAR(reader.published[1].confidence, before, 0.02);
    const auto sightings = std::count_if(reader.published[1].cues.begin(), reader.published[1].cues.end(),
                                         [](const Cue& cue) { return cue.kind == "sighting"; });
    EXPECT_EQ(sightings, 1);
    reader.see({.kind = "sighting", .place = {9, 9, 0}, .confidence = 0.9, .text = "victim 3"}, 1);
    reader.look(2.0);
    EXPECT_EQ(reader.standing().size(), 1U) << "the robot corrected where it saw it";
}

TEST(CandidateBook, CandidatesMoveWithTheirKeyScans) {
    Reader reader;
    reader.book.scanAt(7, Pose(Eigen::Translation3d(1, 0, 0)));
    reader.see({.scan = 7});
    EXPECT_EQ(reader.published[1].scan, 7U);
    EXPECT_LT((reader.published[1].positionInScan - Eigen::Vector3d(1, 1, 0.2)).norm(), 1e-6);
    Pose moved(Eigen::Translation3d(1.5, 0, 0));
    moved.rotate(Eigen::AngleAxisd(std::acos(-1.0) / 2.0, Eigen::Vector3d::UnitZ()));
    reader.book.scanAt(7, moved);
    reader.look(2.0);
    EXPECT_LT((reader.published[1].positionInMap - Eigen::Vector3d(0.5, 1, 0.2)).norm(), 1e-6);
    EXPECT_LT((reader.published[1].positionInScan - Eigen::Vector3d(1, 1, 0.2)).norm(), 1e-6);
}

TEST(CandidateBook, CodesAreToldApartByTheirTextAndTagVictims) {
    Reader reader;
    reader.see({.confidence = 0.95});
    reader.see({.kind = "code", .place = {2.1, 1.1, 0.1}, .confidence = 0.95, .text = "V-07"}, 1);
    reader.see({.kind = "code", .place = {2.4, 1.1, 0.6}, .confidence = 0.95, .text = "yellow-2"}, 1);
    reader.see({.kind = "hazard", .place = {4, 1, 0.6}, .confidence = 0.8, .text = "gas"}, 6);
    reader.look(2.0);
    std::map<Kind, int> kinds;
    for (const CandidateSample& one : reader.standing()) ++kinds[one.kind];
    EXPECT_EQ(kinds[Kind::Victim], 1);
    EXPECT_EQ(kinds[Kind::Code], 2);
    EXPECT_EQ(kinds[Kind::Hazard], 1);
    const auto& cues = reader.published[1].cues;
    EXPECT_TRUE(std::any_of(cues.begin(), cues.end(), [](const Cue& cue) { return cue.text == "V-07"; }));
}

TEST(CandidateBook, UpdatesAreFewAndOnlyWhenSomethingChanged) {
    Reader reader;
    reader.see({}, 200);  // 100 s
    EXPECT_LE(reader.updates, 4);
    EXPECT_EQ(reader.standing().size(), 1U);
}

TEST(CandidateBook, TheOperatorsWordStands) {
    Reader reader;
    reader.see({});
    CandidateSample dismissed = reader.published[1];
    reader.book.take(reader.published[1]);  // our own, back from the log
    dismissed.stamp += std::chrono::seconds(5);
    dismissed.dismissed = true;
    reader.book.take(dismissed);
    reader.published.clear();
    reader.see({}, 30);
    EXPECT_TRUE(reader.standing().empty());
    EXPECT_LE(reader.updates, 4);
}

TEST(CandidateBook, GoesOnWhereAnEarlierSessionEnded) {
    Reader first, second;
    first.see({});
    first.see({.place = {7, 1, 0.2}});
    for (const CandidateSample& one : first.standing()) second.book.take(one);
    second.see({.place = {2.1, 1, 0.2}});
    second.see({.place = {4.5, 4, 0.2}});
    second.look(2.0);
    EXPECT_FALSE(second.published.contains(2)) << "nothing new of it";
    ASSERT_TRUE(second.published.contains(3));
    EXPECT_NEAR(second.published[3].positionInMap.x(), 4.5, 0.01);
}

TEST(CandidateBook, StrangeCuesAreLeftOut) {
    Reader reader;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    reader.see({.place = {nan, 0, 0}});
    reader.see({.deviation = nan});
    reader.see({.confidence = nan}, 1);
    reader.see({.place = {1e30, -1e30, 1e30}}, 2);
    for (int i = 0; i < 2000; ++i) reader.see({.place = {3.0 * i, 0, 0}, .confidence = 0.2}, 1);
    reader.look(2.0);
    SUCCEED();
}

}  // namespace
}  // namespace leitstand::test
