#include "tests/app/live/live_page.h"

#include <algorithm>
#include <string>
#include <utility>

#include <QTableView>

#include "core/io/robot/robot_file.h"
#include "core/mission/mission_state.h"
#include "core/mission/robot_state.h"

namespace leitstand::test {

LiveStation openLiveStation(const std::filesystem::path& folder, int domain) {
    StationSettings settings;
    settings.domain.domain = domain;
    settings.mission.folder = folder / "mission";
    settings.memory = folder / "station.yaml";
    const std::string source = LEITSTAND_SOURCE_DIR;
    for (const char* name : {"kurt3d", "crawler"})
        settings.mission.robots.push_back(readRobot(source + "/resources/robots/" + name + ".yaml").value());
    LiveStation live;
    live.bridge = LiveBridge::open(settings).value();
    live.window = std::make_unique<LiveWindow>(*live.bridge, MapViewSettings{},
                                               LayoutBook(folder / "layouts", source + "/resources/layouts"));
    live.window->resize(1280, 800);
    live.window->show();
    live.window->activateWindow();
    return live;
}

void fileNextFind(LiveWindow& window) {
    auto* table = window.findChild<QTableView*>("finds");
    for (int row = 0; row < table->model()->rowCount(); ++row) {
        const QString name = table->model()->index(row, 0).data().toString();
        const QString state = table->model()->index(row, 1).data().toString();
        if (name != QStringLiteral("?") && !state.contains(QStringLiteral("unconfirmed"))) continue;
        table->selectRow(row);
        QTest::keyClick(&window, Qt::Key_V);
        return;
    }
}

std::size_t confirmedVictims(const Station& station) {
    const MissionStatePtr mission = station.mission();
    return static_cast<std::size_t>(
        std::count_if(mission->victims->begin(), mission->victims->end(), [](const auto& one) {
            return one.first.first == VictimSample::Kind::Victim &&
                   one.second.victim.status == VictimSample::Status::Confirmed;
        }));
}

LivePage::LivePage() {
    open();
    DemoSettings demo;
    demo.program = QStringLiteral(LEITSTAND_ROBOT);
    demo.domain = m_domain.number();
    m_robots = std::make_unique<DemoRobots>(demo);
    m_robots->start();
    EXPECT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
}

LivePage::~LivePage() {
    m_window.reset();
    m_bridge.reset();
}

void LivePage::open() {
    LiveStation live = openLiveStation(m_folder.path().toStdString(), m_domain.number());
    m_bridge = std::move(live.bridge);
    m_window = std::move(live.window);
}

void LivePage::restart() {
    m_window.reset();
    m_bridge.reset();
    open();
    EXPECT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
}

double LivePage::speed(const char* name) const {
    const auto mission = station().mission();
    const auto said = mission->robots.find(name);
    if (said == mission->robots.end() || !said->second->odometry) return 0.0;
    return said->second->odometry->sample.linear.x();
}

void LivePage::lookAt(const QString& name) {
    const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
    if (folder.isEmpty()) return;
    EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
    m_window->grab().save(folder + "/live_" + name + ".png");
}

}  // namespace leitstand::test
