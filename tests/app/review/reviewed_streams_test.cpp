#include "app/services/review/reviewed_streams.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/review/review_scene.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;

/// Half a minute of odometry, 10 a second; pictures, 2 a second, end after 20 s; one word on the mode.
class ReviewedStreamsTest : public testing::Test {
protected:
    void SetUp() override {
        {
            Mission mission(m_folder / "mission");
            for (int i = 0; i <= 300; ++i) {
                mission.sayOdometry(0.1 * i, 0.01 * i);
                if (i % 5 == 0 && i <= 200) mission.sayPicture(0.1 * i, 100);
                if (i == 100) {
                    ModeSample mode;
                    mode.header.stamp = Mission::at(10.0);
                    mode.mode = "explore";
                    mission.publish(10.0, Mission::robot().stream(StreamRole::Mode)->topic, mode);
                }
            }
            mission.close();
        }
        m_log = ReviewLog::open(m_folder / "mission").value();
        m_index = indexOf(*m_log);
        m_scene = std::make_unique<ReviewScene>(*m_log, *m_index);
    }
    StreamStatus at(double seconds, StreamRole role, bool around = true) {
        const auto streams = m_scene->at(Mission::at(seconds), around)->robots.at("kurt3d").link.streams;
        const auto found = std::find_if(streams.begin(), streams.end(),
                                        [role](const StreamStatus& one) { return one.role == role; });
        EXPECT_NE(found, streams.end());
        return found == streams.end() ? StreamStatus() : *found;
    }

    const TemporaryFolder m_folder;
    std::unique_ptr<ReviewLog> m_log;
    ReviewIndexPtr m_index;
    std::unique_ptr<ReviewScene> m_scene;
};

TEST_F(ReviewedStreamsTest, RatesAreThoseOfTheSecondsBefore) {
    EXPECT_NEAR(at(15.0, StreamRole::Odometry).rate, 10.0, 0.5);
    EXPECT_NEAR(at(15.0, StreamRole::Picture).rate, 2.0, 0.3);
    EXPECT_NEAR(at(2.0, StreamRole::Odometry).rate, 10.0, 0.6) << "nothing was recorded before";
    EXPECT_EQ(at(15.0, StreamRole::Picture).samples, 31U);
    EXPECT_FALSE(at(15.0, StreamRole::Mode).steady) << "it comes on change";
    EXPECT_EQ(at(5.0, StreamRole::Mode).samples, 0U);
    EXPECT_TRUE(std::isnan(at(15.0, StreamRole::Odometry).lossRatio)) << "no log tells what never arrived";
}

TEST_F(ReviewedStreamsTest, WhatStoppedIsStaleThenAndNotBefore) {
    EXPECT_FALSE(at(20.4, StreamRole::Picture).stale);
    const StreamStatus stopped = at(28.0, StreamRole::Picture);
    EXPECT_TRUE(stopped.stale);
    EXPECT_EQ(stopped.rate, 0.0);
    EXPECT_NEAR(stopped.age, 8.0, 0.01);
    EXPECT_FALSE(at(28.0, StreamRole::Odometry).stale);
    EXPECT_FALSE(at(12.0, StreamRole::Picture).stale) << "backwards, too";
}

TEST_F(ReviewedStreamsTest, InAHurryTheyAreAsTheyWere) {
    EXPECT_NEAR(at(15.0, StreamRole::Picture).rate, 2.0, 0.3);
    EXPECT_NEAR(at(28.0, StreamRole::Picture, false).rate, 2.0, 0.3);
}

}  // namespace
}  // namespace leitstand::test
