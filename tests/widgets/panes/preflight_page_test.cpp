#include "widgets/preflight/preflight_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/panes/shown.h"

namespace leitstand::test {
namespace {

using Kind = PreflightCheck::Kind;
using State = CheckState;

std::vector<PreflightCheck> checks() {
    PreflightCheck degraded{Kind::RobotConnected, State::Attention, "crawler"};
    degraded.reasons = {{.kind = LinkReason::Kind::Slow, .value = 0.38}};
    PreflightCheck wire{Kind::Wire, State::Attention, "crawler"};
    wire.wire = {"/crawler/scan", {{WireProblem::Kind::OffersLess, "best effort", "reliable"}}};
    return {{Kind::RobotConnected, State::Ok, "kurt3d", {}, 0.022},
            {Kind::StreamsComing, State::Ok, "kurt3d", {}, 16},
            {Kind::PicturesOld, State::Fail, "kurt3d", "left/image/compressed", 4.0},
            {Kind::ClockSteady, State::Ok, "kurt3d", {}, 0.003},
            {Kind::GrantFree, State::Ok, "kurt3d"},
            {Kind::BrakePassed, State::Ok, "kurt3d", {}, 0.31, 0.02},
            degraded,
            wire,
            {Kind::BrakeFailed, State::Fail, "crawler", {}, 1.6, 0.16},
            {Kind::Network, State::Ok, {}, "wlan0 192.168.0.7"},
            {Kind::Stranger, State::Ok, {}, "rover"},
            {Kind::Disk, State::Ok, {}, "/missions/one", 18, 210e6},
            {Kind::GamepadNone, State::Ok},
            {Kind::SoundNone, State::Attention, {}, "No sound device: alarms are seen, not heard."},
            {Kind::Open, State::Note},
            {Kind::Versions, State::Ok, {}, "Leitstand 0.4"}};
}

const std::vector<RobotFace> Faces = {{"kurt3d", "K", "Kurt3D", 0}, {"crawler", "C", "Crawler", 1}};

class PreflightPages : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
};

TEST_P(PreflightPages, ShowsChecksAndHoldsTheBrakeTest) {
    PreflightPage page;
    page.resize(860, 640);
    page.show(checks(), Faces, {"rover"});
    page.showBrake("0.6 m must be free ahead", true, false);
    (void)pictureOf(page, {860, 640}, "preflight", 1.0);
    (void)pictureOf(page, {860, 640}, "preflight_scale2", 2.0);
    QSignalSpy begun(&page, &PreflightPage::brakeBegun), held(&page, &PreflightPage::brakeHeld),
        ended(&page, &PreflightPage::brakeEnded), over(&page, &PreflightPage::overrideWanted),
        add(&page, &PreflightPage::strangerWanted);
    page.findChild<QComboBox*>("brakeRobot")->setCurrentIndex(1);
    auto* button = page.findChild<QPushButton*>("brakeTest");
    QTest::keyPress(button, Qt::Key_Space);
    ASSERT_EQ(begun.count(), 1);
    EXPECT_EQ(begun[0][0].toString(), "crawler");
    EXPECT_TRUE(QTest::qWaitFor([&] { return held.count() > 2; }, 20'000));
    page.show(checks(), Faces, {"rover"});
    EXPECT_EQ(page.brakeRobot(), "crawler") << "what is chosen stays while figures change";
    QTest::keyRelease(button, Qt::Key_Space);
    ASSERT_EQ(ended.count(), 1);
    const auto so = held.count();
    QTest::qWait(120);
    EXPECT_EQ(held.count(), so);
    QTest::mousePress(button, Qt::LeftButton);
    EXPECT_EQ(begun.count(), 2);
    QTest::mouseRelease(button, Qt::LeftButton);
    EXPECT_EQ(ended.count(), 2);
    page.findChild<QCheckBox*>("override")->setChecked(true);
    ASSERT_EQ(over.count(), 1);
    EXPECT_TRUE(over[0][1].toBool());
    QTest::mouseClick(page.findChild<QPushButton*>("add"), Qt::LeftButton);
    ASSERT_EQ(add.count(), 1);
    EXPECT_EQ(add[0][0].toString(), "rover");
    QSignalSpy tones(&page, &PreflightPage::tonesWanted);
    QTest::mouseClick(page.findChild<QPushButton*>("tones"), Qt::LeftButton);
    EXPECT_EQ(tones.count(), 1);
    page.complain("rover.yaml:3: expected a letter");
    EXPECT_EQ(page.findChild<QLabel*>("complaint")->text(), "rover.yaml:3: expected a letter");
    page.show(checks(), Faces, {});
    EXPECT_FALSE(page.findChild<QPushButton*>("add")->isEnabled());
}

INSTANTIATE_TEST_SUITE_P(Themes, PreflightPages, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
