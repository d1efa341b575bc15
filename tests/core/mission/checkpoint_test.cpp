#include "core/mission/state/checkpoint/checkpoint.h"

#include <cmath>
#include <cstring>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/unknown.h"
#include "core/event/map_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/mission/markers/marker_board.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"
#include "tests/core/mission/event_stream.h"

namespace leitstand {
namespace {

using test::at;
using test::event;
using testing::HasSubstr;

MissionState folded(const std::vector<Event>& events) {
    Fold fold;
    for (const Event& event : events) fold.add(event);
    return fold.state();
}

TEST(Checkpoint, HoldsTheWholeState) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const MissionState state = folded(test::randomMission(seed, 500));
        const auto bytes = serialised(state);
        const auto back = deserialised(bytes);
        ASSERT_TRUE(back.ok()) << back.error().text;
        EXPECT_EQ(serialised(*back), bytes);
        EXPECT_EQ(back->finds->size(), state.finds->size());
        EXPECT_EQ(back->keyScans->size(), state.keyScans->size());
        EXPECT_EQ(back->notes->size(), state.notes->size());
        EXPECT_EQ(back->crop != nullptr, state.crop != nullptr);
    }
}

TEST(Checkpoint, HoldsTheNewestReadings) {
    Event reading = event(1, ReadingSample{{at(5), "k/air"}, {22.5, Unknown}}, "k");
    reading.topic = "/k/air";
    const MissionState state = folded({reading});
    ASSERT_EQ(state.robots.at("k")->readings.size(), 1U);
    const auto back = deserialised(serialised(state));
    ASSERT_TRUE(back.ok()) << back.error().text;
    const ReadingSample& kept = back->robots.at("k")->readings.at("/k/air")->sample;
    EXPECT_EQ(kept.header.frame, "k/air");
    EXPECT_EQ(kept.values.at(0), 22.5);
    EXPECT_TRUE(std::isnan(kept.values.at(1)));
}

TEST(Checkpoint, HoldsModelsAndWhatIsSeenInPictures) {
    Event model = event(1, RobotModelSample{"<robot/>"}, "k");
    model.topic = "/k/robot_description";
    Event seen = event(2, DetectionsSample{{at(5), "k/front"}, {{{1, 2}, {3, 4}, 0.5, "door", 0.25}}}, "k");
    seen.topic = "/k/detections";
    const auto back = deserialised(serialised(folded({model, seen})));
    ASSERT_TRUE(back.ok()) << back.error().text;
    const RobotState& robot = *back->robots.at("k");
    EXPECT_EQ(robot.model->sample.urdf, "<robot/>");
    const DetectionsSample& kept = robot.detections.at("/k/detections")->sample;
    EXPECT_EQ(kept.header.frame, "k/front");
    ASSERT_EQ(kept.detections.size(), 1U);
    EXPECT_EQ(kept.detections[0].label, "door");
    EXPECT_EQ(kept.detections[0].size, Eigen::Vector2d(3, 4));
    EXPECT_EQ(kept.detections[0].turned, 0.5);
}

TEST(Checkpoint, HoldsWhatRobotsDraw) {
    Marker marker;
    marker.header = {at(5), "k/map"};
    marker.space = "signs";
    marker.id = 3;
    marker.shape = MarkerShape::LineStrip;
    marker.points = {{1, 2, 3}, {4, 5, 6}};
    marker.lifetime = std::chrono::seconds(60);
    Event drawn = event(1, MarkersSample{false, {marker}}, "k");
    drawn.topic = "/k/markers";
    const auto back = deserialised(serialised(folded({drawn})));
    ASSERT_TRUE(back.ok()) << back.error().text;
    const auto& kept = back->robots.at("k")->markers.at("/k/markers")->sample.drawn.at({"signs", 3});
    EXPECT_EQ(kept.marker->points, marker.points);
    EXPECT_EQ(kept.marker->header.frame, "k/map");
    EXPECT_EQ(kept.received, drawn.received);
}

/// A mission with checkpoints as a station logs them, every @p interval milliseconds.
std::vector<Event> checkpointed(const std::vector<Event>& mission, int interval) {
    std::vector<Event> all;
    Fold fold;
    for (const Event& original : mission) {
        Event next = original;
        next.sequence = original.sequence * 2;  // room for the checkpoints
        if (auto* undo = next.sample.edit<UndoSample>()) undo->event *= 2;
        fold.add(next);
        all.push_back(next);
        if (auto due = fold.dueCheckpoint(next.received, std::chrono::milliseconds(interval))) {
            all.push_back(event(next.sequence + 1, *due));
            fold.add(all.back());
        }
    }
    return all;
}

TEST(Checkpoint, WithTheEventsAfterItEqualsTheWholeReplay) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const auto log = checkpointed(test::randomMission(seed, 400), 500);
        std::vector<MissionState> states;
        Fold fold;
        for (const Event& event : log) {
            fold.add(event);
            states.push_back(fold.state());
        }
        for (std::size_t i = 0; i < log.size(); i += 7) {
            test::MemoryHistory history(log);
            const MissionState jumped = stateAt(history, log[i].sequence);
            ASSERT_EQ(serialised(jumped), serialised(states[i])) << "seed " << seed << ", event " << i;
            EXPECT_LE(history.given(), 120U);
        }
    }
}

TEST(Checkpoint, ABrokenOneIsPassedOver) {
    auto log = checkpointed(test::randomMission(5, 300), 500);
    const MissionState expected = folded(log);
    int broken = 0;
    for (auto event = log.rbegin(); event != log.rend() && broken < 2; ++event) {
        auto* checkpoint = event->sample.edit<CheckpointSample>();
        if (checkpoint == nullptr) continue;
        if (broken++ == 0) {
            checkpoint->version = CheckpointVersion + 1;
        } else {
            checkpoint->state.bytes = checkpoint->state.bytes.first(checkpoint->state.bytes.size() / 2);
        }
    }
    test::MemoryHistory history(log);
    EXPECT_EQ(serialised(stateAt(history, log.back().sequence)), serialised(expected));
}

TEST(Checkpoint, HostileBytesAreAnErrorAndNothingElse) {
    const auto bytes = serialised(folded(test::randomMission(9, 300)));
    EXPECT_FALSE(deserialised({}).ok());
    for (std::size_t length = 0; length < bytes.size(); length += 13) {
        EXPECT_FALSE(deserialised(std::span(bytes).first(length)).ok());
    }
    std::mt19937 random(7);
    for (int round = 0; round < 3'000; ++round) {
        auto broken = bytes;
        for (unsigned i = 0; i <= random() % 3; ++i) {
            broken[8 + random() % (broken.size() - 16)] = static_cast<std::byte>(random());
        }
        // Who means it puts a checksum that fits.
        std::uint64_t sum = 14'695'981'039'346'656'037ULL;
        for (std::size_t i = 0; i + 8 < broken.size(); ++i) {
            sum = (sum ^ std::to_integer<std::uint64_t>(broken[i])) * 1'099'511'628'211ULL;
        }
        std::memcpy(broken.data() + broken.size() - 8, &sum, 8);
        const auto state = deserialised(broken);
        if (!state) {
            EXPECT_THAT(state.error().text, HasSubstr("expected"));
        }
    }
}

TEST(Checkpoint, DamageIsToldByTheChecksumAndOtherVersionsByTheirNumber) {
    auto bytes = serialised(folded(test::randomMission(9, 100)));
    bytes[100] ^= std::byte{1};
    EXPECT_THAT(deserialised(bytes).error().text, HasSubstr("checksum"));
    bytes[4] = static_cast<std::byte>(CheckpointVersion + 1);
    EXPECT_THAT(deserialised(bytes).error().text,
                HasSubstr("expected version " + std::to_string(OldestCheckpointVersion)));
}

TEST(Checkpoint, LinksOfLoopsAreInIt) {
    Fold fold;
    fold.add(event(1, test::keyScan(1, 0.0)));
    fold.add(event(2, test::keyScan(2, 1.0)));
    fold.add(event(3, test::linked(5, LinkKind::Match)));
    fold.add(event(4, test::linked(6, LinkKind::Loop)));
    const auto read = deserialised(serialised(fold.state()));
    ASSERT_TRUE(read.ok()) << read.error().text;
    ASSERT_EQ(read->loops->size(), 1U) << "matches go with their scans";
    const Link& link = read->loops->at(6).link;
    const Link reported = test::linked(6, LinkKind::Loop).links.front();
    EXPECT_EQ(link.pose.matrix(), reported.pose.matrix());
    EXPECT_EQ(link.information, reported.information);
    EXPECT_EQ(link.station, reported.station);
}

TEST(Checkpoint, IsDueWhenSomethingHappenedAndTimeHasPassed) {
    Fold fold;
    EXPECT_FALSE(fold.dueCheckpoint(at(0)).has_value());
    fold.add(event(1, test::victim(1, "a")));
    const auto first = fold.dueCheckpoint(at(10));
    ASSERT_TRUE(first.has_value());
    EXPECT_EQ(first->sequence, 1U);
    fold.add(event(2, *first));
    EXPECT_FALSE(fold.dueCheckpoint(at(19'000)).has_value());
    EXPECT_TRUE(fold.dueCheckpoint(at(20'010)).has_value());
    EXPECT_FALSE(fold.dueCheckpoint(at(60'000)).has_value());
}

}  // namespace
}  // namespace leitstand
