// What the operator sees when a robot or its camera fails, and when it is there again.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <memory>
#include <vector>

#include <QImage>
#include <QTest>

#include <gmock/gmock.h>

#include "core/event/stream_role.h"
#include "tests/app/live/live_page.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/drive/mode_cell.h"
#include "widgets/painting/pane_paint.h"
#include "widgets/painting/theme.h"
#include "widgets/robots/robot_chip_button.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

/// The middle one of what each pixel of @p picture is by @p figure.
template <class Figure>
int median(const QImage& picture, Figure figure) {
    std::vector<int> values;
    for (int y = 0; y < picture.height(); y += 3) {
        for (int x = 0; x < picture.width(); x += 3) values.push_back(figure(picture.pixelColor(x, y)));
    }
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Kurt3D as a process that fails and comes back.
class RobotTroubles : public LivePage {
protected:
    explicit RobotTroubles(std::vector<RobotDescription> team = {shippedRobot("kurt3d")})
        : LivePage(Robots::None, std::move(team)) {
        startKurt();
    }
    void startKurt() {
        m_kurt = std::make_unique<ChildProcess>(
            program("leitstand-robot"),
            std::vector<std::string>{"kurt3d", "--arena", "yellow", "--seed", "7", "--domain",
                                     std::to_string(m_domain.number())});
    }
    [[nodiscard]] CameraPane& camera() const { return *m_window->findChild<CameraPane*>("cameraPane"); }
    /// What the strip says, all of it.
    [[nodiscard]] std::string strip() const {
        return m_window->findChild<ModeCell*>()->accessibleDescription().toStdString();
    }
    [[nodiscard]] const RobotChip& chip() const { return m_window->findChild<RobotChipButton*>()->chip(); }
    /// How far the picture on the screen is from grey; what is drawn over it is less than half of it.
    [[nodiscard]] int colour() const {
        const QImage shown = camera().grab(camera().pictureArea().toRect()).toImage();
        return median(shown, [](const QColor& one) {
            const auto [least, most] = std::minmax({one.red(), one.green(), one.blue()});
            return most - least;
        });
    }
    /// Whether the age of the picture, on the right of the pane's head, is written in amber.
    [[nodiscard]] bool ageIsAmber() const {
        const QRect head(camera().width() / 2, 0, camera().width() / 2, paneHeadHeight(camera().font()));
        const QImage shown = camera().grab(head).toImage();
        const QColor amber = coloursOf(presentTheme()).attention;
        for (int y = 0; y < shown.height(); ++y) {
            for (int x = 0; x < shown.width(); ++x) {
                const QColor one = shown.pixelColor(x, y);
                const int off =
                    std::max({std::abs(one.red() - amber.red()), std::abs(one.green() - amber.green()),
                              std::abs(one.blue() - amber.blue())});
                if (off < 40) return true;
            }
        }
        return false;
    }
    /// F2 and W, as an operator does: what was held meanwhile is let go first.
    void drive() {
        if (!m_window->driving()) press(Qt::Key_F2);
        ASSERT_TRUE(m_window->driving());
        ASSERT_TRUE(soon([&] { return mayDrive(); })) << strip();
        QTest::qWait(300);
        QTest::keyPress(m_window.get(), Qt::Key_W);
        ASSERT_TRUE(soon([&] { return speed() > 0.1; })) << strip();
    }
    void letGo() { QTest::keyRelease(m_window.get(), Qt::Key_W); }
    [[nodiscard]] bool live() const {
        return robot().link.state == LinkState::Connected && chip().link == LinkState::Connected &&
               colour() > Colourful;
    }

    static constexpr int Colourful = 25, Grey = 14;  ///< wood is far above, a grey picture below
    std::unique_ptr<ChildProcess> m_kurt;
};

TEST_F(RobotTroubles, ARobotThatIsUnpluggedIsLostInWordsAndGreyAndDrivesAgainWhenItIsBack) {
    ASSERT_TRUE(soon([&] { return live(); })) << chip().details.toStdString() << colour();
    drive();
    m_kurt->signal(SIGKILL);
    EXPECT_EQ(m_kurt->wait(), -1);
    ASSERT_TRUE(soon([&] { return chip().link == LinkState::Lost; }));
    letGo();
    EXPECT_EQ(chip().tone, Tone::Attention);
    EXPECT_THAT(chip().details.toStdString(), HasSubstr("lost"));
    EXPECT_TRUE(soon([&] { return strip().find("LINK LOST") != std::string::npos; })) << strip();
    EXPECT_THAT(strip(), HasSubstr("silent for"));
    EXPECT_TRUE(soon([&] { return colour() < Grey; })) << colour();
    EXPECT_TRUE(ageIsAmber());
    lookAt("unplugged");

    startKurt();
    ASSERT_TRUE(soon([&] { return live(); })) << chip().details.toStdString() << colour();
    EXPECT_TRUE(soon([&] { return strip().find("LINK LOST") == std::string::npos; })) << strip();
    EXPECT_LT(std::abs(speed()), 0.02) << "it does not go on by itself";
    drive();
    letGo();
    EXPECT_TRUE(soon([&] { return std::abs(speed()) < 0.02; }));
}

/// Its scanner is not listened to: the driver has the camera alone.
class FrozenCamera : public RobotTroubles {
protected:
    FrozenCamera() : RobotTroubles({withoutScanner()}) {}

    static RobotDescription withoutScanner() {
        RobotDescription robot = shippedRobot("kurt3d");
        std::erase_if(robot.streams, [](const StreamDescription& stream) {
            return stream.role == StreamRole::Points || stream.role == StreamRole::Ranges;
        });
        return robot;
    }
    void freeze() { m_kurt->signal(SIGUSR1); }
};

TEST_F(FrozenCamera, CapsTheSpeedInWordsAndGreysThePictureUntilItIsLiveAgain) {
    ASSERT_TRUE(soon([&] { return live(); })) << chip().details.toStdString() << colour();
    EXPECT_FALSE(ageIsAmber());
    drive();
    const double creep = 0.2 * shippedRobot("kurt3d").maxSpeed;
    ASSERT_TRUE(soon([&] { return robot().drive.velocity.forward > creep + 0.05; }));
    freeze();
    ASSERT_TRUE(soon([&] {
        const DriveView drive = robot().drive;
        return drive.sight.reason == SightReason::FrozenPicture && drive.velocity.forward <= creep + 1e-6;
    }));
    bool crept = false;
    ASSERT_TRUE(soon([&] {
        crept = crept || strip().find("creep speed: it is the same picture for") != std::string::npos;
        return strip().find("held: it is the same picture for") != std::string::npos;
    })) << strip();
    EXPECT_TRUE(crept) << "the cap is told before the robot is held";
    EXPECT_THAT(strip(), HasSubstr("hold G to drive without eyes"));
    EXPECT_TRUE(soon([&] { return std::abs(speed()) < 0.02; })) << "it stands";
    EXPECT_TRUE(soon([&] { return colour() < Grey && ageIsAmber(); })) << colour();
    EXPECT_EQ(chip().link, LinkState::Connected) << "pictures still come";
    EXPECT_TRUE(soon([&] { return camera().accessibleDescription().contains(QStringLiteral("same for")); }))
        << camera().accessibleDescription().toStdString();
    lookAt("frozen");

    freeze();  // not any more
    ASSERT_TRUE(soon([&] { return robot().drive.sight.factor >= 1.0; })) << strip();
    EXPECT_TRUE(soon([&] { return live() && !ageIsAmber(); })) << colour();
    EXPECT_TRUE(soon([&] { return strip().find("sticks must be neutral first") != std::string::npos; }))
        << strip();
    EXPECT_LT(std::abs(speed()), 0.02) << "motion never resumes by itself";
    letGo();
    drive();
    letGo();
}

}  // namespace
}  // namespace leitstand::test
