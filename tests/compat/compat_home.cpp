#include "tests/compat/compat_home.h"

#include <cstdlib>
#include <memory>
#include <optional>

#include <QApplication>
#include <QEvent>
#include <QLocale>

#include "app/services/handin/writing/report_folder.h"
#include "tests/compat/lines.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// One application, whose settings are looked for below a folder of its own from its start on.
class Environment final : public testing::Environment {
public:
    void SetUp() override {
        m_home.emplace();
        qputenv("HOME", m_home->path().c_str());
        qputenv("XDG_CONFIG_HOME", (*m_home / ".config").c_str());
        qputenv("XDG_DATA_HOME", (*m_home / ".local/share").c_str());
        qputenv("TZ", "UTC");
        qputenv("QT_QPA_PLATFORM", ("offscreen:configfile=" + compatFile("screen.json").string()).c_str());
        static int argc = 1;
        static char name[] = "leitstand";
        static char* argv[] = {name, nullptr};
        m_application = std::make_unique<QApplication>(argc, argv);
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    }
    void TearDown() override {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        m_application.reset();
        m_home.reset();
    }

private:
    std::optional<TemporaryFolder> m_home;
    std::unique_ptr<QApplication> m_application;
};

[[maybe_unused]] const auto* const environment = testing::AddGlobalTestEnvironment(new Environment);

}  // namespace

fs::path homeFolder() {
    return std::getenv("HOME");
}

fs::path CompatHome::kept(const std::string& name) {
    return compatFile("home-0.2/.config/leitstand/" + name);
}

CompatHome::CompatHome() {
    fs::remove_all(homeFolder() / ".config");
    fs::remove_all(homeFolder() / ".local");
    fs::copy(compatFile("home-0.2"), homeFolder(), fs::copy_options::recursive);
    fs::copy(compatFile("mission-0.2"), m_mission, fs::copy_options::recursive);
    // A window would go on with the hand-in of the mission where its operator had it.
    EXPECT_TRUE(keepReportFolder(m_mission, {}));
}

}  // namespace leitstand::test
