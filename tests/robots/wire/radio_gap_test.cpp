#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/stream_role.h"
#include "tests/robots/wire/wire_station.h"
#include "tests/support/net/radio_link.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// Slices of Kurt3D over a radio link of 10 Mbit/s with 5 % loss.
class WireGap : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string why = whyNoNodesInNamespaces(); !why.empty())
            GTEST_SKIP() << "SKIPPED: the radio link needs network namespaces and TUN: " << why;
        m_radio.emplace();
        {
            const InNamespace there(m_radio->robots());
            m_there = nodeIn(m_domain, {.scanLimit = {7000, 10}});
            m_wire = must(RobotWire::create(*m_there, m_robot));
        }
        const InNamespace here(m_radio->station());
        m_here = nodeIn(m_domain);
        m_station =
            std::make_unique<RobotListener>(*m_here, std::vector{*m_robot.stream(StreamRole::Points)});
        ASSERT_TRUE(waitUntil(
            [&] {
                publish(2, 10);
                return m_station->count(Topic) > 2;
            },
            60s));
        EXPECT_TRUE(waitUntil([&] { return m_station->count(Topic) > 0 && newest() == m_number; }, 60s));
    }
    void publish(int rows, int columns) {
        CloudSample slice;
        slice.header = {Time(std::chrono::milliseconds(100 * ++m_number)), "laser"};
        slice.rows = rows;
        slice.columns = columns;
        slice.points.assign(static_cast<std::size_t>(rows * columns), Eigen::Vector3f(1.0F, 2.0F, 3.0F));
        slice.intensities.assign(slice.points.size(), 9.0F);
        slice.times.assign(slice.points.size(), 5);
        slice.rings.assign(slice.points.size(), 1);
        m_wire->publish({StreamRole::Points, "scanner", slice});
    }
    [[nodiscard]] static std::int64_t numberOf(const CloudSample& slice) {
        return slice.header.stamp.time_since_epoch() / 100ms;
    }
    [[nodiscard]] std::int64_t newest() const { return numberOf(m_station->all<CloudSample>(Topic).back()); }
    /// @p slices are said while nothing passes; how long it took until all that are kept had come [s].
    double refill(int slices, int rows, int columns, std::chrono::seconds atMost) {
        m_radio->setOutage(true);
        const std::int64_t first = m_number + 1;
        for (int i = 0; i < slices; ++i) publish(rows, columns);
        m_radio->setOutage(false);
        const auto back = Clock::now();
        EXPECT_EQ(m_wire->counts().unpublished, 0U);
        EXPECT_TRUE(waitUntil([&] { return newest() == m_number; }, atMost))
            << newest() << " of " << m_number;
        std::int64_t expected = std::max(first, m_number - 599);
        for (const CloudSample& slice : m_station->all<CloudSample>(Topic)) {
            if (numberOf(slice) < first) continue;
            EXPECT_EQ(numberOf(slice), expected) << "in order, none missing";
            expected = numberOf(slice) + 1;
        }
        return std::chrono::duration<double>(Clock::now() - back).count();
    }
    inline static const std::string Topic = "/kurt3d/points";
    const TestDomain m_domain;
    const RobotDescription m_robot = fileOf("kurt3d");
    std::optional<RadioLink> m_radio;
    std::unique_ptr<Node> m_there, m_here;
    std::unique_ptr<RobotWire> m_wire;
    std::unique_ptr<RobotListener> m_station;
    std::int64_t m_number = 0;
};
using WireGapLong = WireGap;

TEST_F(WireGap, OfSixtySecondsIsRefilledInOrder) {
    std::printf("590 small slices came %.1f s after the gap\n", refill(590, 2, 10, 90s));
}

TEST_F(WireGapLong, SixtySecondsOfWholeSlicesAreRefilled) {
    const double seconds = refill(590, 8, 161, 5min);
    std::printf("59 s of whole slices came within %.1f s\n", seconds);
    EXPECT_LT(seconds, 120.0);
}

}  // namespace
}  // namespace leitstand::test
