#include "tests/app/window/review_page.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "app/window/layouts/layout_feature.h"
#include "core/event/cloud_sample.h"
#include "core/event/picture_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"
#include "tests/app/review/written_mission.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand::test {
namespace {

using Mission = WrittenMission;

/// Forty seconds in which everything that a robot measures changes: a wall comes nearer, what is warm moves
/// through the infrared picture, the picture grows brighter, CO2 rises.
class ReviewFollows : public ReviewPage {
protected:
    static constexpr int Seconds = 40;

    void SetUp() override {
        {
            Mission mission(m_mission);
            for (int i = 0; i <= 10 * Seconds; ++i) sayAll(mission, 0.1 * i);
        }
        m_bridge = ReviewBridge::open(m_mission).value();
        openWindow();
    }
    static void sayAll(Mission& mission, double seconds) {
        mission.sayOdometry(seconds, 0.02 * seconds);
        sayWall(mission, seconds, 3.0F - 0.05F * static_cast<float>(seconds));
        const int halves = static_cast<int>(std::lround(2.0 * seconds));
        if (std::abs(2.0 * seconds - halves) > 0.01) return;
        mission.sayPicture(seconds, 20 + 2 * halves);
        sayWarmth(mission, seconds, halves % 30);
        mission.publish(
            seconds, Mission::robot().stream(StreamRole::Gas, "co2")->topic,
            GasSample{
                .header = {Mission::at(seconds), "kurt3d/co2"}, .gas = "co2", .ppm = 500.0 + 40.0 * seconds});
    }
    static void sayWall(Mission& mission, double seconds, float distance) {
        CloudSample wall;
        wall.header = {Mission::at(seconds), "kurt3d/laser"};
        wall.rows = 25;
        wall.columns = 31;
        for (int row = 0; row < wall.rows; ++row) {
            const float heading = -0.6F + 0.05F * static_cast<float>(row);
            for (int column = 0; column < wall.columns; ++column)
                wall.points.emplace_back(distance * std::cos(heading), distance * std::sin(heading),
                                         -0.4F + 0.05F * static_cast<float>(column));
        }
        mission.publish(seconds, Mission::robot().stream(StreamRole::Points)->topic, wall);
    }
    /// Centikelvin; a body at @p column of a picture of 32 x 24.
    static void sayWarmth(Mission& mission, double seconds, int column) {
        cv::Mat picture(24, 32, CV_16UC1, cv::Scalar(29'300));
        picture(cv::Rect(column, 8, 2, 8)).setTo(cv::Scalar(30'700));
        std::vector<unsigned char> png;
        cv::imencode(".png", picture, png);
        const auto bytes = std::make_shared<std::vector<std::byte>>();
        for (const unsigned char one : png) bytes->push_back(std::byte(one));
        PictureSample warmth;
        warmth.header = {Mission::at(seconds), "kurt3d/ir"};
        warmth.compressed = true;
        warmth.encoding = "16UC1; png";
        warmth.content = {bytes, *bytes};
        mission.publish(seconds, Mission::robot().stream(StreamRole::Thermal, "ir")->topic, warmth);
    }

    [[nodiscard]] double brightness() const {
        auto& pane = find<CameraPane>("cameraPane");
        const QRect area = pane.pictureArea().toRect();
        if (area.isEmpty()) return -1.0;
        const QImage picture =
            pane.grab(area).toImage().scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        return qGray(picture.pixel(0, 0));
    }
    /// Whether @p pane shows other things at other moments, and the same again at the first.
    void expectFollows(QWidget& pane, const char* name) {
        ASSERT_TRUE(pane.isVisible()) << name;
        goTo(12.0);
        QImage first = pane.grab().toImage();
        // Pictures are decoded on a thread: what is shown settles a moment after.
        int same = 0;
        for (int i = 0; i < 100 && same < 3; ++i) {
            QTest::qWait(100);
            const QImage now = pane.grab().toImage();
            same = now == first ? same + 1 : 0;
            first = now;
        }
        ASSERT_EQ(same, 3) << name << ": never settles";
        goTo(32.0);
        EXPECT_TRUE(soon([&] { return pane.grab().toImage() != first; })) << name << ": stays as it was";
        goTo(12.0);
        EXPECT_TRUE(soon([&] { return pane.grab().toImage() == first; })) << name << ": does not go back";
    }
};

TEST_F(ReviewFollows, CameraInfraredScanAndStripShowTheMoment) {
    ASSERT_TRUE(m_window->layouts().use(QStringLiteral("review"))) << m_window->newest().toStdString();
    expectFollows(find<QWidget>("cameraPane"), "camera");
    expectFollows(find<QWidget>("rightPane"), "infrared");
    auto* around = m_window->findChild<VirtualScanPane*>();
    auto* strip = m_window->findChild<DriveStrip*>();
    ASSERT_TRUE(around != nullptr && strip != nullptr);
    expectFollows(*around, "virtual scan");
    expectFollows(*strip, "strip with CO2");
    lookAt("follows");
}

TEST_F(ReviewFollows, ThePictureIsThatOfTheMomentInBothDirections) {
    ASSERT_TRUE(m_window->layouts().use(QStringLiteral("review"))) << m_window->newest().toStdString();
    goTo(35.0);
    ASSERT_TRUE(soon([&] { return brightness() > 110.0; })) << brightness();
    goTo(5.0);
    EXPECT_TRUE(soon([&] { return brightness() >= 0.0 && brightness() < 80.0; })) << brightness();
}

TEST_F(ReviewFollows, TwoTimesIsTwoTimes) {
    goTo(4.0);
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](auto span) { return std::chrono::duration<double>(span).count(); };
    for (const double rate : {2.0, -2.0}) {
        const Time before = m_bridge->player().position();
        m_bridge->player().play(rate);
        const auto began = Clock::now();
        ASSERT_TRUE(soon([&] { return Clock::now() - began > std::chrono::milliseconds(2'500); }));
        const double passed = seconds(m_bridge->player().position() - before);
        const double real = seconds(Clock::now() - began);
        m_bridge->player().play(0.0);
        EXPECT_NEAR(passed / real, rate, 0.2 * std::abs(rate));
        goTo(30.0);
    }
}

}  // namespace
}  // namespace leitstand::test
