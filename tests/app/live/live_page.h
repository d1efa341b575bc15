#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include "app/window/live/demo_robots.h"
#include "app/window/live/live_window.h"
#include "app/window/source/live_bridge.h"
#include "core/robot/robot_description.h"
#include "tests/support/dds/test_domain.h"

namespace leitstand::test {

/// A station with its window, as an operator has it.
struct LiveStation {
    std::unique_ptr<LiveBridge> bridge;
    std::unique_ptr<LiveWindow> window;  // ends first
};
/// Opens or resumes the mission in @p folder / "mission" on @p robots, empty: both shipped ones; what the
/// station remembers and layouts are beside it.
[[nodiscard]] LiveStation openLiveStation(const std::filesystem::path& folder, int domain,
                                          std::vector<RobotDescription> robots = {});

/// The robot's file that comes with the program.
[[nodiscard]] RobotDescription shippedRobot(const char* name);

/// What a scripted operator does with the list of finds: files the surest candidate, or confirms what is
/// open.
void fileNextFind(LiveWindow& window);
[[nodiscard]] std::size_t confirmedVictims(const Station& station);

/// The live window on both simulated robots, which are processes beside it.
class LivePage : public testing::Test {
protected:
    static constexpr int Patience = 60'000;  ///< of real robots on a busy machine [ms]

    LivePage();
    /// No robot is there until the test starts it. @p team: the station's robots, empty: both shipped ones.
    enum class Robots { None };
    explicit LivePage(Robots none, std::vector<RobotDescription> team = {});
    ~LivePage() override;

    /// Both simulated robots; @p arena: a grade, or a file.
    void startRobots(const QString& arena = QStringLiteral("yellow"));

    template <class Holds>
    [[nodiscard]] static bool soon(Holds holds) {
        return QTest::qWaitFor(holds, Patience);
    }
    [[nodiscard]] Station& station() const { return m_bridge->station(); }
    [[nodiscard]] RobotView robot(const char* name = "kurt3d") const { return station().robot(name); }
    /// As its odometry tells [m/s].
    [[nodiscard]] double speed(const char* name = "kurt3d") const;
    /// Whether the robot moves as soon as a key is pressed: a key pressed earlier must be let go first.
    [[nodiscard]] bool mayDrive(const char* name = "kurt3d") const;
    /// Closes the window and the station, and opens them again on the same mission; the robots go on.
    /// @p between is called while nobody has the mission open.
    void restart(const std::function<void()>& between = {});
    /// For people: a picture of the window in the folder LEITSTAND_PICTURES.
    void lookAt(const QString& name);
    void press(Qt::Key key) { QTest::keyClick(m_window.get(), key); }

    const TestDomain m_domain;
    const QTemporaryDir m_folder;
    std::unique_ptr<LiveBridge> m_bridge;
    std::unique_ptr<LiveWindow> m_window;
    std::unique_ptr<DemoRobots> m_robots;

private:
    void open();

    const std::vector<RobotDescription> m_team;  ///< empty: both shipped ones
};

}  // namespace leitstand::test
