#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/finds/find_desk.h"
#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/picture_samples.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"

namespace leitstand::test {

inline Time at(double seconds) {
    return Time(std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds)));
}

/// Stripes whose edges are blurred over so many pixels.
inline SharedBytes raw(int blur) {
    auto bytes = std::make_shared<std::vector<std::byte>>(64 * 48);
    for (int i = 0; i < 64 * 48; ++i) {
        const int phase = i % 64 % 32;
        const int level = std::clamp((phase < 16 ? phase : 32 - phase) * 255 / blur, 0, 255);
        (*bytes)[static_cast<std::size_t>(i)] = static_cast<std::byte>(level);
    }
    return {bytes, std::span<const std::byte>(*bytes)};
}

/// What a robot says: pictures of which one is sharp, gas that rises.
class FindingRobot {
public:
    FindingRobot() {
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
        setup.record = [this](const FindSample& sample) {
            add(sample);
            return Result<void>();
        };
        setup.recordCandidate = [this](const CandidateSample& sample) {
            add(sample);
            return Result<void>();
        };
        setup.undo = [this](const UndoSample& sample) {
            add(sample);
            return Result<void>();
        };
        setup.locate = [this](const ChosenEvidence& chosen, FindDeskSetup::Located answer) {
            m_asked = chosen;
            if (m_search.valid()) m_search.wait();
            if (m_answers) answer(m_place);
        };
        setup.shows = [this](const std::vector<Event>& pictures, const Eigen::Vector3d& inMap,
                             FindDeskSetup::Shown answer) {
            m_lookedAt = inMap;
            answer(std::vector<bool>(pictures.size(), m_looksThere));
        };
        setup.robotInMap = [this](const std::string&) { return m_base; };
        setup.notify = [this](const std::string& text) {
            const std::scoped_lock lock(m_mutex);
            m_reported.push_back(text);
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
    [[nodiscard]] static std::vector<std::uint64_t> evidenceOf(const FindSample& find) {
        std::vector<std::uint64_t> all;
        for (const VictimEvidence& one : find.evidence) all.push_back(one.sequence);
        return all;
    }

    /// Waits until all that was asked for is filed.
    void finish() { m_desk.reset(); }
    const FindSample& find(std::uint32_t number, FindSample::Kind kind = FindSample::Kind::Victim) {
        return m_state.finds->at({kind, number}).victim;
    }

    FindingRobot m_robot;
    std::mutex m_mutex;
    MissionState m_state;
    std::optional<PlacedFind> m_place = PlacedFind{0, {2.0, 1.0, 0.4}, 0.1};
    std::shared_future<void> m_search;  ///< until then nothing is known of a place; none: it is known at once
    bool m_answers = true;              ///< false: nobody says where what a picture shows is
    std::optional<Pose> m_base = Pose::Identity();
    std::optional<ChosenEvidence> m_asked;
    bool m_looksThere = true;
    std::optional<Eigen::Vector3d> m_lookedAt;
    std::vector<std::string> m_reported;
    std::unique_ptr<FindDesk> m_desk;
};

}  // namespace leitstand::test
