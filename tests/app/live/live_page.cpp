#include "tests/app/live/live_page.h"

#include "core/io/robot/robot_file.h"
#include "core/mission/mission_state.h"
#include "core/mission/robot_state.h"

namespace leitstand::test {

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
    StationSettings settings;
    const std::filesystem::path folder = m_folder.path().toStdString();
    settings.domain.domain = m_domain.number();
    settings.mission.folder = folder / "mission";
    settings.memory = folder / "station.yaml";
    const std::string source = LEITSTAND_SOURCE_DIR;
    for (const char* name : {"kurt3d", "crawler"})
        settings.mission.robots.push_back(readRobot(source + "/resources/robots/" + name + ".yaml").value());
    m_bridge = LiveBridge::open(settings).value();
    m_window = std::make_unique<LiveWindow>(*m_bridge, MapViewSettings{},
                                            LayoutBook(folder / "layouts", source + "/resources/layouts"));
    m_window->resize(1280, 800);
    m_window->show();
    m_window->activateWindow();
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
