#include "app/services/thinning/mission_thinning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/log/event_decoder.h"
#include "app/services/log/replay/bag_history.h"
#include "core/event/find_sample.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

class ThinningTest : public testing::Test {
protected:
    ThinningTest() {
        WrittenMission mission(m_folder / "whole");
        writeMinute(mission);
        mission.close();
    }
    /// Sequences and topics of a mission's events.
    static std::map<std::uint64_t, std::string> eventsOf(const std::filesystem::path& mission) {
        std::map<std::uint64_t, std::string> all;
        auto bag = BagReader::open(mission);
        EXPECT_TRUE(bag) << bag.error().text;
        BagCursor cursor = (*bag)->read();
        while (const auto event = cursor.next()) all[event->sequence] = event->topic;
        EXPECT_THAT((*bag)->problems(), testing::IsEmpty());
        return all;
    }
    static std::size_t countOf(const std::map<std::uint64_t, std::string>& events, const std::string& topic) {
        return static_cast<std::size_t>(std::count_if(events.begin(), events.end(),
                                                      [&](const auto& one) { return one.second == topic; }));
    }

    const TemporaryFolder m_folder;
};

TEST_F(ThinningTest, KeepsWhatStationsSaidAndLittleOfTheRest) {
    const auto done = thinMission(m_folder / "whole", m_folder / "thin", {});
    ASSERT_TRUE(done) << done.error().text;
    const auto whole = eventsOf(m_folder / "whole"), thin = eventsOf(m_folder / "thin");
    EXPECT_EQ(done->kept, thin.size());
    EXPECT_EQ(done->kept + done->left, whole.size());
    for (const auto& [sequence, topic] : thin) EXPECT_EQ(whole.at(sequence), topic) << "sequences stay";
    for (const char* topic : {"/leitstand/victims", "/leitstand/key_scans", "/leitstand/notes"})
        EXPECT_EQ(countOf(thin, topic), countOf(whole, topic)) << topic;
    EXPECT_EQ(countOf(thin, "/leitstand/checkpoints"), 0U);
    const std::string pictures = WrittenMission::robot().stream(StreamRole::Picture)->topic;
    EXPECT_GT(countOf(whole, pictures), 100U);
    EXPECT_NEAR(static_cast<double>(countOf(thin, pictures)), 60.0, 3.0) << "one a second";
    const std::string clouds = WrittenMission::robot().stream(StreamRole::Points)->topic;
    EXPECT_EQ(countOf(thin, clouds), 0U);
}

TEST_F(ThinningTest, TheStateAtTheEndIsTheSameButForWhatWasCounted) {
    ASSERT_TRUE(thinMission(m_folder / "whole", m_folder / "thin", {}));
    const auto stateOf = [](const std::filesystem::path& mission) {
        auto bag = std::move(BagReader::open(mission)).value();
        EventDecoder decoder({WrittenMission::robot()});
        BagHistory history(*bag, decoder);
        return stateAt(history, bag->lastSequence());
    };
    const MissionState whole = stateOf(m_folder / "whole"), thin = stateOf(m_folder / "thin");
    EXPECT_EQ(thin.finds->size(), whole.finds->size());
    EXPECT_EQ(thin.keyScans->size(), whole.keyScans->size());
    EXPECT_EQ(thin.notes->size(), whole.notes->size());
    EXPECT_EQ(thin.decisions->size(), whole.decisions->size());
}

TEST_F(ThinningTest, KeepsTheEvidenceOfFindsThatAnotherStationTold) {
    const auto stream = [](StreamRole role) { return WrittenMission::robot().stream(role)->topic; };
    const std::string pictures = stream(StreamRole::Picture), clouds = stream(StreamRole::Points);
    std::uint64_t picture = 0, cloud = 0;
    {
        WrittenMission mission(m_folder / "shared");
        for (int i = 0; i <= 20; ++i) {
            mission.sayPlace(0.1 * i, 0.01 * i);
            if (i == 15) cloud = mission.sequence();
            mission.sayPicture(0.1 * i, 20 + i);
            if (i == 15) picture = mission.sequence();
        }
        FindSample find;
        find.stamp = find.found = WrittenMission::at(2.0);
        find.station = "other";
        find.number = 1;
        find.robot = "kurt3d";
        // Its numbers are of the other log, and are not told.
        find.evidence = {{"picture", pictures, 0, WrittenMission::at(1.5)},
                         {"scan", clouds, 0, WrittenMission::at(1.5)},
                         {"picture", "/crawler/left", 0, WrittenMission::at(1.5)}};
        mission.publish(2.5, "/leitstand/victims", find);
    }
    ASSERT_TRUE(thinMission(m_folder / "shared", m_folder / "thin", {}));
    const auto thin = eventsOf(m_folder / "thin");
    EXPECT_TRUE(thin.contains(picture));
    EXPECT_TRUE(thin.contains(cloud));
    EXPECT_EQ(countOf(thin, pictures), 4U) << "and one a second";
    EXPECT_EQ(countOf(thin, clouds), 1U) << "and no other";
}

TEST_F(ThinningTest, OnlyTheBeginningWhereThatIsWished) {
    ASSERT_TRUE(thinMission(m_folder / "whole", m_folder / "thin", {.seconds = 15.0}));
    const auto whole = eventsOf(m_folder / "whole"), thin = eventsOf(m_folder / "thin");
    EXPECT_EQ(countOf(thin, "/leitstand/victims"), 0U) << "it is filed at 20 s";
    EXPECT_GT(countOf(thin, "/leitstand/key_scans"), 1U);
    EXPECT_LT(countOf(thin, "/leitstand/key_scans"), countOf(whole, "/leitstand/key_scans"));
}

TEST_F(ThinningTest, NothingIsOverwrittenAndWhatIsNoMissionIsTold) {
    EXPECT_FALSE(thinMission(m_folder / "whole", m_folder / "whole", {}));
    EXPECT_FALSE(thinMission(m_folder / "missing", m_folder / "thin", {}));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "thin")) << "nothing is left behind";
}

}  // namespace
}  // namespace leitstand::test
