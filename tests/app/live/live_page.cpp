#include "tests/app/live/live_page.h"

#include <algorithm>
#include <string>
#include <utility>

#include <QTableView>

#include "core/event/find_sample.h"
#include "core/event/motion_samples.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/robot_state.h"
#include "tests/app/window_size.h"
#include "tests/support/places.h"

namespace leitstand::test {

RobotDescription shippedRobot(const char* name) {
    return readRobot(sourceFolder() + "/resources/robots/" + name + ".yaml").value();
}

LiveStation openLiveStation(const std::filesystem::path& folder, int domain,
                            std::vector<RobotDescription> robots) {
    if (robots.empty()) robots = {shippedRobot("kurt3d"), shippedRobot("crawler")};
    StationSettings settings;
    settings.domain.domain = domain;
    settings.mission.folder = folder / "mission";
    settings.memory = folder / "station.yaml";
    const std::string source = sourceFolder();
    settings.mission.robots = std::move(robots);
    LiveStation live;
    live.bridge = LiveBridge::open(settings).value();
    live.window = std::make_unique<LiveWindow>(*live.bridge, MapViewSettings{},
                                               LayoutBook(folder / "layouts", source + "/resources/layouts"));
    live.window->resize(windowSize());
    live.window->show();
    live.window->activateWindow();
    return live;
}

void fileNextFind(LiveWindow& window) {
    auto* table = window.findChild<QTableView*>("finds");
    for (int row = 0; row < table->model()->rowCount(); ++row) {
        const QString name = table->model()->index(row, 0).data().toString();
        const QString state = table->model()->index(row, 1).data().toString();
        if (!name.endsWith(u'?') && !state.contains(QStringLiteral("unconfirmed"))) continue;
        table->selectRow(row);
        QTest::keyClick(&window, Qt::Key_V);
        return;
    }
}

std::size_t confirmedVictims(const Station& station) {
    const MissionStatePtr mission = station.mission();
    return static_cast<std::size_t>(
        std::count_if(mission->finds->begin(), mission->finds->end(), [](const auto& one) {
            return one.first.first == FindSample::Kind::Victim &&
                   one.second.victim.status == FindSample::Status::Confirmed;
        }));
}

LivePage::LivePage() : LivePage(Robots::None) {
    startRobots();
}

LivePage::LivePage(Robots /*none*/, std::vector<RobotDescription> team) : m_team(std::move(team)) {
    open();
    EXPECT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
}

void LivePage::startRobots(const QString& arena) {
    DemoSettings demo;
    demo.program = QString::fromStdString(program("leitstand-robot"));
    demo.arena = arena;
    demo.domain = m_domain.number();
    m_robots = std::make_unique<DemoRobots>(demo);
    m_robots->start();
}

LivePage::~LivePage() {
    m_window.reset();
    m_bridge.reset();
}

void LivePage::open() {
    LiveStation live = openLiveStation(m_folder.path().toStdString(), m_domain.number(), m_team);
    m_bridge = std::move(live.bridge);
    m_window = std::move(live.window);
}

void LivePage::restart(const std::function<void()>& between) {
    m_window.reset();
    m_bridge.reset();
    if (between) between();
    open();
    EXPECT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
}

bool LivePage::mayDrive(const char* name) const {
    const RobotView one = robot(name);
    return one.grant.mine && one.drive.listening && one.drive.sight.factor >= 1.0 && !one.drive.needsNeutral;
}

double LivePage::speed(const char* name) const {
    const auto mission = station().mission();
    const auto reported = mission->robots.find(name);
    if (reported == mission->robots.end() || !reported->second->odometry) return 0.0;
    return reported->second->odometry->sample.linear.x();
}

void LivePage::lookAt(const QString& name) {
    const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
    if (folder.isEmpty()) return;
    EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
    m_window->grab().save(folder + "/live_" + name + ".png");
}

}  // namespace leitstand::test
