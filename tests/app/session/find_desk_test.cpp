#include "app/session/finds/find_desk.h"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mission/fold.h"
#include "core/mission/victims/dismissal.h"
#include "core/perception/picture_encoding.h"

namespace leitstand {
namespace {

using Kind = VictimSample::Kind;
using Status = VictimSample::Status;
using testing::HasSubstr;
using testing::SizeIs;

Time at(double seconds) {
    return Time(std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds)));
}

/// Stripes whose edges are blurred over so many pixels.
SharedBytes raw(int blur) {
    auto bytes = std::make_shared<std::vector<std::byte>>(64 * 48);
    for (int i = 0; i < 64 * 48; ++i) {
        const int phase = i % 64 % 32;
        const int level = std::clamp((phase < 16 ? phase : 32 - phase) * 255 / blur, 0, 255);
        (*bytes)[static_cast<std::size_t>(i)] = static_cast<std::byte>(level);
    }
    return {bytes, std::span<const std::byte>(*bytes)};
}

/// What a robot says: pictures of which one is sharp, gas that rises.
class Robot {
public:
    Robot() {
        m_robot.name = "kurt3d";
        m_robot.title = "Kurt3D";
        StreamDescription infrared;
        infrared.role = StreamRole::Thermal;
        infrared.sensor = "ir";
        m_robot.streams.push_back(infrared);
    }
    [[nodiscard]] const RobotDescription& description() const { return m_robot; }

    [[nodiscard]] Event event(Time when, StreamRole role, const std::string& sensor, Sample sample) {
        return {++m_sequence, when, "kurt3d", "/kurt3d/" + sensor, role, sensor, std::move(sample)};
    }
    [[nodiscard]] Event picture(Time when, int blur) {
        PictureSample sample;
        sample.header.stamp = when;
        sample.encoding = "mono8";
        sample.width = 64;
        sample.height = 48;
        sample.step = 64;
        sample.content = raw(blur);
        return event(when, StreamRole::Picture, "left", sample);
    }
    /// 20 degrees C with a body as wide as a hand at @p column.
    [[nodiscard]] Event infrared(Time when, int column, double celsius) {
        auto bytes = std::make_shared<std::vector<std::byte>>(2 * 64 * 48);
        for (int i = 0; i < 64 * 48; ++i) {
            const bool warm = std::hypot(i % 64 - column, i / 64 - 24) < 5.0;
            const auto value = static_cast<unsigned>(100.0 * ((warm ? celsius : 20.0) + 273.15));
            (*bytes)[static_cast<std::size_t>(2 * i)] = static_cast<std::byte>(value & 0xFF);
            (*bytes)[static_cast<std::size_t>(2 * i + 1)] = static_cast<std::byte>(value >> 8);
        }
        PictureSample sample;
        sample.header.stamp = when;
        sample.encoding = "mono16";
        sample.width = 64;
        sample.height = 48;
        sample.step = 128;
        sample.content = {bytes, std::span<const std::byte>(*bytes)};
        return event(when, StreamRole::Thermal, "ir", sample);
    }
    [[nodiscard]] Event gas(Time when, double ppm) {
        GasSample sample;
        sample.ppm = ppm;
        return event(when, StreamRole::Gas, "co2", sample);
    }
    [[nodiscard]] Event info(const std::string& sensor = "left") {
        CameraInfoSample info;
        info.width = 64;
        info.height = 48;
        info.intrinsics = {60, 0, 32, 0, 60, 24, 0, 0, 1};
        return event(at(0), StreamRole::CameraInfo, sensor, info);
    }

private:
    RobotDescription m_robot;
    std::uint64_t m_sequence = 1'000;
};

class FindDeskTest : public testing::Test {
protected:
    FindDeskTest() {
        FindDeskSetup setup;
        setup.robots = {m_robot.description()};
        setup.station = "s";
        setup.mission = [this] {
            const std::scoped_lock lock(m_mutex);
            return std::make_shared<const MissionState>(m_state);
        };
        setup.say = [this](const VictimSample& sample) {
            add(sample);
            return Result<void>();
        };
        setup.sayCandidate = [this](const CandidateSample& sample) {
            add(sample);
            return Result<void>();
        };
        setup.undo = [this](const UndoSample& sample) {
            add(sample);
            return Result<void>();
        };
        setup.locate = [this](const ChosenEvidence& chosen, FindDeskSetup::Located answer) {
            m_asked = chosen;
            answer(m_place);
        };
        setup.shows = [this](const std::vector<Event>& pictures, const Eigen::Vector3d& inMap,
                             FindDeskSetup::Shown answer) {
            m_lookedAt = inMap;
            answer(std::vector<bool>(pictures.size(), m_looksThere));
        };
        setup.robotInMap = [this](const std::string&) { return m_base; };
        setup.tell = [this](const std::string& text) {
            const std::scoped_lock lock(m_mutex);
            m_told.push_back(text);
        };
        setup.now = [] { return at(10.0); };
        m_desk = std::make_unique<FindDesk>(std::move(setup));
    }

    void add(const Sample& sample) {
        const std::scoped_lock lock(m_mutex);
        const std::uint64_t sequence = m_state.sequence + 1;
        m_state = fold(std::move(m_state),
                       {sequence, at(10.0), "", "/leitstand/victims", std::nullopt, "", sample});
    }
    /// The station believes that somebody is at (2, 1, 0.4), by an infrared picture of long ago.
    void believe(double confidence = 0.8) {
        CandidateSample candidate;
        candidate.station = "s";
        candidate.id = 7;
        candidate.positionInMap = {2.0, 1.0, 0.4};
        candidate.deviation = 0.05;
        candidate.confidence = confidence;
        candidate.cues = {
            {.kind = "heat", .robot = "kurt3d", .topic = "/kurt3d/ir", .sequence = 12, .value = 33.5},
            {.kind = "motion", .robot = "kurt3d", .topic = "/kurt3d/left", .sequence = 13}};
        add(candidate);
    }
    [[nodiscard]] const CandidateSample& candidate() { return m_state.candidates->at(7).candidate; }
    [[nodiscard]] static std::vector<std::uint64_t> evidenceOf(const VictimSample& find) {
        std::vector<std::uint64_t> all;
        for (const VictimEvidence& one : find.evidence) all.push_back(one.sequence);
        return all;
    }

    /// Waits until all that was asked for is filed.
    void finish() { m_desk.reset(); }
    const VictimSample& find(std::uint32_t number, Kind kind = Kind::Victim) {
        return m_state.victims->at({kind, number}).victim;
    }

    Robot m_robot;
    std::mutex m_mutex;
    MissionState m_state;
    std::optional<PlacedFind> m_place = PlacedFind{0, {2.0, 1.0, 0.4}, 0.1};
    std::optional<Pose> m_base = Pose::Identity();
    std::optional<ChosenEvidence> m_asked;
    bool m_looksThere = true;
    std::optional<Eigen::Vector3d> m_lookedAt;
    std::vector<std::string> m_told;
    std::unique_ptr<FindDesk> m_desk;
};

TEST_F(FindDeskTest, WhatIsPointedToIsLookedForInThePictureThatWasPointedInto) {
    m_desk->take(m_robot.info());
    m_desk->take(m_robot.picture(at(8.5), 2));  // sharper, but the robot moved on
    const Event pointed = m_robot.picture(at(9.5), 14);
    m_desk->take(pointed);
    m_desk->take(m_robot.picture(at(9.9), 12));
    m_desk->freeze("kurt3d", Kind::Victim, "right", PicturePoint{"left", {0.25, 0.75}, pointed.sequence});
    finish();
    ASSERT_THAT(*m_state.victims, SizeIs(1));
    EXPECT_EQ(find(1).evidence.at(0).sequence, pointed.sequence);
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->picture->sequence, pointed.sequence);
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(16.0, 36.0));
}

TEST_F(FindDeskTest, TheInfraredPictureThatWasPointedIntoIsTheEvidence) {
    m_desk->take(m_robot.info());
    m_desk->take(m_robot.info("ir"));
    m_desk->take(m_robot.picture(at(9.0), 2));
    const Event pointed = m_robot.infrared(at(9.2), 16, 31.0);
    m_desk->take(pointed);
    m_desk->take(m_robot.infrared(at(9.6), 48, 36.0));  // another body came into sight
    m_desk->freeze("kurt3d", Kind::Victim, "left", PicturePoint{"ir", {0.25, 0.5}, pointed.sequence});
    finish();
    ASSERT_THAT(*m_state.victims, SizeIs(1));
    std::vector<std::uint64_t> kept;
    for (const VictimEvidence& one : find(1).evidence) {
        if (one.kind == "thermal") kept.push_back(one.sequence);
    }
    EXPECT_THAT(kept, testing::ElementsAre(pointed.sequence)) << "that one, and nothing twice";
    EXPECT_NEAR(find(1).heat.value, 31.0, 0.1) << "of what was pointed to";
    ASSERT_TRUE(m_asked && m_asked->picture);
    EXPECT_EQ(m_asked->picture->sequence, pointed.sequence);
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(16.0, 24.0));
}

TEST_F(FindDeskTest, PointingIntoAPictureThatIsGoneStillFiles) {
    m_place.reset();
    m_desk->take(m_robot.info("ir"));
    m_desk->take(m_robot.infrared(at(9.6), 48, 36.0));
    m_desk->freeze("kurt3d", Kind::Victim, "left", PicturePoint{"ir", {0.25, 0.5}, 7});
    finish();
    ASSERT_THAT(*m_state.victims, SizeIs(1));
    EXPECT_FALSE(m_asked) << "a pixel of a picture that is gone says nothing about another one";
    EXPECT_EQ(find(1).evidence.size(), 1U) << "what there is is kept";
    EXPECT_THAT(m_told, testing::Contains(HasSubstr("no range there")));
}

TEST_F(FindDeskTest, PointingWithoutAnyPictureFilesWithoutEvidence) {
    m_place.reset();
    m_desk->freeze("kurt3d", Kind::Victim, "left", PicturePoint{"ir", {0.25, 0.5}, 7});
    finish();
    ASSERT_THAT(*m_state.victims, SizeIs(1));
    EXPECT_TRUE(find(1).evidence.empty());
    EXPECT_EQ(find(1).positionInMap.x(), 1.0) << "ahead of the robot";
}

TEST_F(FindDeskTest, TheSharpestPictureOfTheLastSecondsIsFrozen) {
    m_desk->take(m_robot.info());
    m_desk->take(m_robot.picture(at(1.0), 1));  // sharp, but long ago
    m_desk->take(m_robot.picture(at(8.0), 16));
    const Event sharp = m_robot.picture(at(8.5), 2);
    m_desk->take(sharp);
    m_desk->take(m_robot.picture(at(9.9), 14));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    ASSERT_THAT(*m_state.victims, SizeIs(1));
    ASSERT_THAT(find(1).evidence, SizeIs(1));
    EXPECT_EQ(find(1).evidence[0].sequence, sharp.sequence);
    EXPECT_EQ(find(1).positionInMap, Eigen::Vector3d(2.0, 1.0, 0.4));
    EXPECT_EQ(find(1).found, at(10.0));
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(32.0, 24.0)) << "the middle of the picture that is looked at";
}

TEST_F(FindDeskTest, WhereTheOperatorPointsToCounts) {
    m_desk->take(m_robot.info());
    m_desk->take(m_robot.picture(at(9.0), 2));
    m_desk->freeze("kurt3d", Kind::Hazard, "left", PicturePoint{"left", {0.25, 0.75}});
    finish();
    EXPECT_EQ(m_asked->pixel, Eigen::Vector2d(16.0, 36.0));
    EXPECT_EQ(find(1, Kind::Hazard).kind, Kind::Hazard);
}

TEST_F(FindDeskTest, GasCountsWhereItRose) {
    m_desk->take(m_robot.gas(at(1.0), 420.0));
    m_desk->take(m_robot.gas(at(9.0), 1'800.0));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_EQ(find(1).co2.value, 1'800.0);
    EXPECT_EQ(find(1).heat.state, VictimSign::State::Unknown) << "nothing warm was seen";
}

TEST_F(FindDeskTest, TheGasOfTheLastMinuteIsFrozenAsATrace) {
    std::vector<std::uint64_t> readings;
    for (int i = 0; i < 1'000; ++i) {  // ten a second, for 100 s
        const Event reading = m_robot.gas(at(0.1 * i), i == 995 ? 2'000.0 : 400.0 + i);
        readings.push_back(reading.sequence);
        m_desk->take(reading);
    }
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    std::vector<std::uint64_t> frozen;
    for (const VictimEvidence& one : find(1).evidence) {
        EXPECT_EQ(one.kind, "gas");
        frozen.push_back(one.sequence);
    }
    EXPECT_GE(frozen.size(), 55U);
    EXPECT_LE(frozen.size(), 63U) << "one a second is enough to draw it";
    EXPECT_GE(frozen.front(), readings[395]) << "of the last minute";
    EXPECT_THAT(frozen, testing::Contains(readings[995])) << "a peak is not thinned away";
    EXPECT_EQ(frozen.back(), readings.back());
    EXPECT_TRUE(std::is_sorted(frozen.begin(), frozen.end()));
    EXPECT_EQ(find(1).co2.value, 1'399.0);
}

TEST_F(FindDeskTest, ASecondFindOfTheSameMinuteNamesTheSameReadings) {
    for (int i = 0; i < 300; ++i) m_desk->take(m_robot.gas(at(0.2 * i), 400.0 + i % 7));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    ASSERT_THAT(*m_state.victims, SizeIs(1)) << "it joins the first";
    EXPECT_LE(find(1).evidence.size(), 63U);
}

TEST_F(FindDeskTest, WithoutARangeItIsFiledAheadOfTheRobotAndSaid) {
    m_place.reset();
    m_desk->take(m_robot.info());
    m_desk->take(m_robot.picture(at(9.0), 2));
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_EQ(find(1).positionInMap.x(), 1.0);
    EXPECT_GE(find(1).deviation, 0.5);
    EXPECT_THAT(m_told, testing::Contains(HasSubstr("no range there")));
}

TEST_F(FindDeskTest, ARobotThatIsNotInTheMapSaysSo) {
    m_base.reset();
    m_place.reset();
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(*m_state.victims, SizeIs(0));
    EXPECT_THAT(m_told, testing::Contains(HasSubstr("Kurt3D is not in the map yet")));
}

TEST_F(FindDeskTest, TheSecondPressConfirmsAndUndoTakesItBack) {
    m_desk->take(m_robot.info());
    m_desk->freezeAt("kurt3d", Kind::Victim, {3.0, 0.0, 0.2});
    while (!m_desk->newest()) std::this_thread::yield();
    const FindKey key = *m_desk->newest();
    ASSERT_TRUE(m_desk->confirm(key));
    EXPECT_EQ(find(1).status, Status::Confirmed);
    ASSERT_TRUE(m_desk->undo());
    EXPECT_EQ(find(1).status, Status::Hypothesis);
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.victims, SizeIs(0));
    EXPECT_THAT(m_desk->undo().error().text, HasSubstr("nothing on finds"));
    EXPECT_FALSE(m_desk->confirm(key));
    EXPECT_FALSE(m_desk->fileCandidate(9));
}

TEST_F(FindDeskTest, ACandidateIsFiledWithItsCuesAndWithWhatItsRobotSeesThere) {
    believe();
    m_desk->take(m_robot.picture(at(8.5), 16));
    const Event sharp = m_robot.picture(at(9.0), 2), gas = m_robot.gas(at(9.5), 450.0);
    m_desk->take(sharp);
    m_desk->take(gas);
    ASSERT_TRUE(m_desk->fileCandidate(7));
    finish();
    ASSERT_THAT(*m_state.victims, SizeIs(1));
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13, sharp.sequence, gas.sequence));
    EXPECT_EQ(m_lookedAt, Eigen::Vector3d(2.0, 1.0, 0.4));
    EXPECT_EQ(find(1).positionInMap, Eigen::Vector3d(2.0, 1.0, 0.4)) << "where the station has it";
    EXPECT_EQ(find(1).heat.value, 33.5);
    EXPECT_EQ(find(1).robot, "kurt3d");
    EXPECT_EQ(candidate().victim, 1U) << "it is shown once";
    EXPECT_THAT(m_told, testing::Contains(HasSubstr("V1 filed")));
}

TEST_F(FindDeskTest, WhatLooksElsewhereOrIsOldIsNoEvidenceOfACandidate) {
    believe();
    m_looksThere = false;
    m_desk->take(m_robot.picture(at(9.0), 2));
    m_desk->take(m_robot.gas(at(9.5), 450.0));
    ASSERT_TRUE(m_desk->fileCandidate(7));
    m_desk->finish();
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13)) << "its cues alone";
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.victims, SizeIs(0));
    EXPECT_FALSE(isFiled(m_state, candidate())) << "it stands again";
}

TEST_F(FindDeskTest, PicturesOfLongAgoAreNoEvidenceOfACandidate) {
    believe();
    m_desk->take(m_robot.picture(at(3.0), 2));  // the robot has been silent since
    ASSERT_TRUE(m_desk->fileCandidate(7));
    finish();
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13));
    EXPECT_FALSE(m_lookedAt) << "nobody is asked about nothing";
}

TEST_F(FindDeskTest, WhatIsFrozenBesideACandidateTakesItsCues) {
    believe();
    const Event picture = m_robot.picture(at(9.0), 2);
    m_desk->take(m_robot.info());
    m_desk->take(picture);
    m_place = PlacedFind{0, {2.3, 1.2, 0.4}, 0.1};
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    m_desk->finish();
    EXPECT_THAT(evidenceOf(find(1)), testing::UnorderedElementsAre(12, 13, picture.sequence));
    EXPECT_EQ(find(1).heat.value, 33.5);
    EXPECT_EQ(find(1).motion.state, VictimSign::State::Present);
    EXPECT_EQ(find(1).positionInMap.x(), 2.3) << "where the operator saw it";
    EXPECT_EQ(candidate().victim, 1U);
    m_place = PlacedFind{0, {6.0, 1.0, 0.4}, 0.1};
    m_desk->freeze("kurt3d", Kind::Victim, "left");
    finish();
    EXPECT_THAT(evidenceOf(find(2)), testing::ElementsAre(picture.sequence)) << "that is elsewhere";
}

TEST_F(FindDeskTest, ADismissedCandidateIsSaidSoAndUndoBringsItBack) {
    believe(0.52);
    m_desk->freezeAt("kurt3d", Kind::Victim, {8.0, 0.0, 0.2});
    m_desk->finish();
    ASSERT_TRUE(m_desk->dismiss(7));
    EXPECT_TRUE(candidate().dismissed);
    EXPECT_TRUE(isDismissal(candidate())) << "by a person, though it is not very sure";
    ASSERT_TRUE(m_desk->undo());
    EXPECT_FALSE(candidate().dismissed) << "the newest act first";
    EXPECT_THAT(*m_state.victims, SizeIs(1));
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.victims, SizeIs(0));
    EXPECT_FALSE(m_desk->undo());
    EXPECT_FALSE(m_desk->dismiss(9));
}

TEST_F(FindDeskTest, AnActThatIsNewerThanADismissalIsTakenBackBeforeIt) {
    believe();
    ASSERT_TRUE(m_desk->dismiss(7));
    m_desk->freezeAt("kurt3d", Kind::Victim, {8.0, 0.0, 0.2});
    m_desk->finish();
    ASSERT_TRUE(m_desk->undo());
    EXPECT_THAT(*m_state.victims, SizeIs(0));
    EXPECT_TRUE(candidate().dismissed);
    ASSERT_TRUE(m_desk->undo());
    EXPECT_FALSE(candidate().dismissed);
}

}  // namespace
}  // namespace leitstand
