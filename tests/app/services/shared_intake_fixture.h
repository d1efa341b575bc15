#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/team/shared_evidence.h"
#include "app/services/team/shared_intake.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand::test {

using namespace std::chrono_literals;

/// An intake before a log of its own: what enters is folded at once.
class SharedIntakeTest : public testing::Test {
protected:
    static Sender process(std::uint8_t number) {
        Sender sender;
        sender.bytes.fill(number);
        return sender;
    }
    static Time at(int seconds) { return Time(std::chrono::seconds(1'700'000'000 + seconds)); }

    static KeyScanSample keyScan(std::uint64_t id, int entered = 0) {
        auto scan = std::make_shared<Scan>();
        scan->robot = "kurt3d";
        scan->points = {{1, 2, 3}};
        KeyScanSample sample;
        sample.stamp = at(entered != 0 ? entered : static_cast<int>(id));
        sample.id = id;
        sample.scan = scan;
        return sample;
    }

    static ScanPosesSample poses(std::vector<std::uint64_t> scans, double x = 1.0) {
        ScanPosesSample sample;
        sample.stamp = at(100);
        sample.station = "other";
        for (const std::uint64_t id : scans) {
            ScanPose pose;
            pose.scan = id;
            pose.scanInMap.translation().x() = x;
            sample.poses.push_back(pose);
        }
        return sample;
    }

    static RobotPlaceSample crawlerAt(double x) {
        RobotPlaceSample sample;
        sample.stamp = at(100);
        sample.station = "other";
        sample.robot = "crawler";
        sample.baseInMap.translation().x() = x;
        return sample;
    }

    static FindSample victimFound(int found, int stamp, const std::string& station) {
        FindSample victim;
        victim.number = 3;
        victim.found = at(found);
        victim.stamp = at(stamp);
        victim.station = station;
        return victim;
    }

    void begin() {
        SharedIntakeSetup setup;
        setup.me = Me;
        setup.station = "us";
        setup.onJoined = [this] { ++m_joined; };
        setup.fileAgain = [this](const FindSample& find) { m_filedAgain.push_back(find); };
        setup.mission = [this] { return m_state; };
        setup.holdsMap = [this] { return m_holdsMap; };
        setup.enter = [this](RawEvent raw) {
            raw.sequence = m_state->sequence + 1;
            auto event = decodeStationEvent(raw);
            if (!event) {
                m_entered.push_back("broken");
                return;
            }
            m_state = std::make_shared<const MissionState>(fold(*m_state, *event));
            m_entered.push_back(nameOf(event->sample));
        };
        setup.notify = [this](const std::string& text) { m_reported += text + "\n"; };
        m_intake = std::make_unique<SharedIntake>(std::move(setup));
    }
    void receive(const Sample& sample, std::string_view topic, std::optional<Sender> from = {}) {
        RawEvent event;
        event.topic = topic;
        event.type = typeOf(sample);
        event.received = at(200);
        event.cdr = must(encode(sample, event.type));
        m_intake->take(std::move(event), from.value_or(Other), m_now);
    }
    void receive(const KeyScanSample& scan, std::optional<Sender> from = {}) {
        receive(scan, station_topic::KeyScans, from);
    }
    void receive(const ScanPosesSample& sample, std::optional<Sender> from = {}) {
        receive(sample, station_topic::ScanPoses, from);
    }
    void heartbeat(std::chrono::seconds later) {
        m_now += later;
        GrantSample grant;
        grant.station = "other";
        receive(grant, station_topic::Grants);
    }
    /// What entered since, but for grants.
    [[nodiscard]] std::vector<std::string> entered() {
        std::vector<std::string> all = std::exchange(m_entered, {});
        std::erase(all, "grant");
        return all;
    }
    [[nodiscard]] double placeOf(std::uint64_t scan) const {
        return m_state->keyScans->at(scan).pose.scanInMap.translation().x();
    }
    static std::string nameOf(const Sample& sample) {
        if (const auto* scan = sample.as<KeyScanSample>()) return "scan " + std::to_string(scan->id);
        if (const auto* some = sample.as<ScanPosesSample>())
            return "poses of " + std::to_string(some->poses.size());
        if (sample.is<RobotPlaceSample>()) return "place";
        if (sample.is<ScanBodiesSample>()) return "bodies";
        if (sample.is<FindSample>()) return "victim";
        if (sample.is<ClockSample>()) return "clock";
        if (sample.is<GrantSample>()) return "grant";
        return "other";
    }

    const Sender Me = process(1), Other = process(2), Third = process(3);
    MissionStatePtr m_state = std::make_shared<const MissionState>();
    bool m_holdsMap = false;
    int m_joined = 0;
    std::vector<FindSample> m_filedAgain;
    SteadyTime m_now{};
    std::string m_reported;
    std::vector<std::string> m_entered;
    std::unique_ptr<SharedIntake> m_intake;
};

}  // namespace leitstand::test
