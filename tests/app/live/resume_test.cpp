// The program on live robots, ended by a crash and started again.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/writing/report_folder.h"
#include "app/services/places/mission_map.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/live_application.h"
#include "app/window/live/live_window.h"
#include "core/event/map_samples.h"
#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::chrono::seconds Patience(60);

class ResumeTest : public testing::Test {
protected:
    [[nodiscard]] std::unique_ptr<ChildProcess> start(std::vector<std::string> arguments) const {
        return std::make_unique<ChildProcess>(
            program("leitstand"), arguments,
            std::vector<std::string>{"QT_QPA_PLATFORM=offscreen",
                                     "XDG_CONFIG_HOME=" + (m_home / "config").string(),
                                     "XDG_DATA_HOME=" + (m_home / "data").string()});
    }
    /// The folder that it says to record into; empty: it never did.
    static std::string recordedInto(const ChildProcess& station) {
        const std::string before = "recorded into ";
        if (!waitUntil([&] { return station.out().find(before) != std::string::npos; }, Patience)) return {};
        const std::string out = station.out();
        const auto begin = out.find(before) + before.size();
        return out.substr(begin, out.find('\n', begin) - begin);
    }
    /// Waits until the mission in @p folder has something.
    static bool isWritten(const fs::path& folder) {
        return waitUntil(
            [&] {
                std::error_code none;
                for (const auto& file : fs::directory_iterator(folder, none)) {
                    if (file.path().extension() == ".db3" && fs::file_size(file.path(), none) > 0)
                        return true;
                }
                return false;
            },
            Patience);
    }
    [[nodiscard]] std::vector<std::string> onKurt() const {
        return {"--live",
                "--robot",
                "kurt3d",
                "--interface",
                "lo",
                "--domain",
                std::to_string(m_domain.number())};
    }
    /// What onKurt() says, for a station in this process, which keeps everything in this test's folder.
    [[nodiscard]] Options here() const {
        for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"})
            EXPECT_TRUE(qputenv(place, QByteArray::fromStdString(m_home.path().string())));
        Options options;
        options.live = true;
        options.robots = {"kurt3d"};
        options.network.interfaces = {"lo"};
        options.network.domain = m_domain.number();
        return options;
    }

    TestDomain m_domain;
    TemporaryFolder m_home;
};

TEST_F(ResumeTest, TheNewestMissionIsGoneOnWithAndWithTheRobotsOfLastTime) {
    auto station = start(onKurt());
    const std::string first = recordedInto(*station);
    ASSERT_THAT(first, HasSubstr((m_home / "data").string()));
    ASSERT_TRUE(isWritten(first)) << station->out();
    station->signal(SIGKILL);
    station->wait();
    station = start({"--resume"});
    EXPECT_EQ(recordedInto(*station), first) << station->out();
    station->signal(SIGKILL);
    station->wait();
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // missions are named by the second
    station = start(onKurt());
    const std::string second = recordedInto(*station);
    EXPECT_NE(second, first) << "nobody asked for that";
    ASSERT_TRUE(isWritten(second)) << station->out();
    station->signal(SIGKILL);
    station->wait();
    station = start({"--resume"});
    EXPECT_EQ(recordedInto(*station), second);
}

TEST_F(ResumeTest, ASignalEndsItAsClosingItsWindowDoes) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const fs::path mission = m_home / ("mission" + std::to_string(signal)),
                       out = m_home / ("hand-in" + std::to_string(signal));
        auto arguments = onKurt();
        arguments.insert(arguments.end(), {"--mission", mission.string()});
        auto station = start(arguments);
        ASSERT_EQ(recordedInto(*station), mission);
        ASSERT_TRUE(isWritten(mission)) << station->out();
        ASSERT_TRUE(keepReportFolder(mission, out)) << "as the window does";
        station->signal(signal);
        EXPECT_EQ(station->wait(), 0) << station->out();
        EXPECT_TRUE(fs::exists(out / "SHA256SUMS")) << "the report is written once more";
        const ProcessOutcome reported = runProcess(program("leitstandctl"), {"info", mission.string()});
        EXPECT_THAT(reported.out, testing::Not(HasSubstr("cut off"))) << reported.err;
    }
}

TEST_F(ResumeTest, WithoutAMissionItIsTold) {
    auto station = start({"--resume"});
    EXPECT_EQ(station->wait(), 1);
    EXPECT_THAT(station->out(), HasSubstr("no mission was recorded so far"));
    EXPECT_EQ(runProcess(program("leitstand"), {"--resume", "--mission", "there"}).exitCode, 2);
}

TEST_F(ResumeTest, ANewMissionBeginsInTheMapOfAnEarlierOne) {
    const fs::path earlier = fs::path(sourceFolder()) / "resources/samples/yellow-7",
                   today = m_home / "today";
    auto arguments = onKurt();
    arguments.insert(arguments.end(), {"--map-of", earlier.string(), "--mission", today.string()});
    auto station = start(arguments);
    ASSERT_EQ(recordedInto(*station), today) << station->out();
    station->signal(SIGTERM);
    EXPECT_EQ(station->wait(), 0) << station->out();
    const auto scans = keyScansOf(today);
    ASSERT_EQ(scans.size(), keyScansOf(earlier).size());
    EXPECT_EQ(scans.front().scan->robot, "kurt3d@yellow-7");
    // Once more it would be another map in the same mission.
    station = start(arguments);
    EXPECT_EQ(station->wait(), 1);
    EXPECT_THAT(station->out(), HasSubstr("today: it is there already"));
    EXPECT_EQ(runProcess(program("leitstand"), {"--map-of", earlier.string()}).exitCode, 2);
}

TEST_F(ResumeTest, TheWindowBeginsANewMissionInTheMapOfAnother) {
    const Options options = here();
    const QString earlier =
        QString::fromStdString((fs::path(sourceFolder()) / "resources/samples/yellow-7").string());
    bool asked = false;
    QTimer glance;
    QObject::connect(&glance, &QTimer::timeout, [&] {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* const window = qobject_cast<LiveWindow*>(widget);
            if (window == nullptr || !window->isVisible()) continue;
            if (auto* const question = window->findChild<QMessageBox*>("newInMap")) {
                EXPECT_TRUE(question->text().contains("yellow-7")) << question->text().toStdString();
                asked = true;
                question->findChild<QPushButton*>("goOn")->click();
            } else if (asked) {
                window->close();
            } else if (auto* const choice = window->findChild<QFileDialog*>("mapOf")) {
                emit choice->fileSelected(QString::fromStdString(m_home.path().string()));
                EXPECT_TRUE(window->recent().join(u' ').contains("expected")) << "that is no mission";
                emit choice->fileSelected(earlier);
            } else {
                window->commands().trigger(QStringLiteral("mission.inMap"));
            }
            return;
        }
    });
    glance.start(300);
    EXPECT_EQ(runLive(options), 0);
    ASSERT_TRUE(asked);
    std::vector<std::size_t> scans;
    for (const auto& one : fs::directory_iterator(m_home / "leitstand" / "missions"))
        scans.push_back(keyScansOf(one.path()).size());
    EXPECT_THAT(scans, testing::UnorderedElementsAre(0U, keyScansOf(fs::path(earlier.toStdString())).size()))
        << "the one that was begun first is kept";
}

TEST_F(ResumeTest, TheWindowOffersToGoOnWithTheMissionBefore) {
    Options options = here();
    const auto sessions = [](const fs::path& mission) {
        int count = 0;
        for (const auto& file : fs::directory_iterator(mission)) count += file.path().extension() == ".db3";
        return count;
    };
    const auto missions = [&] {
        std::vector<fs::path> all;
        for (const auto& one : fs::directory_iterator(m_home / "leitstand" / "missions")) all.push_back(one);
        std::sort(all.begin(), all.end());
        return all;
    };
    const auto looksAtWindows = [](const std::function<void(LiveWindow&)>& look) {
        auto glance = std::make_unique<QTimer>();
        QObject::connect(glance.get(), &QTimer::timeout, [look] {
            for (QWidget* widget : QApplication::topLevelWidgets()) {
                auto* const window = qobject_cast<LiveWindow*>(widget);
                if (window != nullptr && window->isVisible()) look(*window);
            }
        });
        glance->start(300);
        return glance;
    };
    int windows = 0;
    {
        const auto closes = looksAtWindows([&](LiveWindow& window) {
            EXPECT_FALSE(window.commands().find(QStringLiteral("mission.earlier"))->isEnabled());
            ++windows;
            window.close();
        });
        EXPECT_EQ(runLive(options), 0);
    }
    EXPECT_EQ(windows, 1);
    ASSERT_EQ(missions().size(), 1U);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // missions are named by the second
    bool asked = false;
    {
        const auto goesOn = looksAtWindows([&](LiveWindow& window) {
            if (auto* const question = window.findChild<QMessageBox*>("goOnWithEarlier")) {
                EXPECT_FALSE(question->isModal());
                asked = true;
                return question->findChild<QPushButton*>("goOn")->click();
            }
            EXPECT_TRUE(window.commands().find(QStringLiteral("mission.earlier"))->isEnabled())
                << "the one that was left is offered, too";
            if (asked) {
                window.close();
                return;
            }
            EXPECT_THAT(window.recent().join(u' ').toStdString(), HasSubstr("recorded until a moment ago"));
            window.commands().trigger(QStringLiteral("mission.earlier"));
        });
        EXPECT_EQ(runLive(options), 0);
    }
    EXPECT_TRUE(asked);
    ASSERT_EQ(missions().size(), 2U) << "the one that was begun meanwhile is kept";
    EXPECT_EQ(sessions(missions().front()), 2);
    EXPECT_EQ(sessions(missions().back()), 1);
}

TEST_F(ResumeTest, AKeptReportIsWrittenOnceMoreWhenTheStationIsClosed) {
    Options options = here();
    options.mission = (m_home / "mission").string();
    const fs::path out = m_home / "hand-in";
    QTimer glance;
    QObject::connect(&glance, &QTimer::timeout, [&] {
        for (QWidget* window : QApplication::topLevelWidgets()) {
            if (qobject_cast<LiveWindow*>(window) == nullptr || !window->isVisible()) continue;
            EXPECT_TRUE(keepReportFolder(options.mission, out)) << "as the window does";
            glance.stop();
            window->close();
        }
    });
    glance.start(500);
    EXPECT_EQ(runLive(options), 0);
    bool printed = false;
    for (const auto& file : fs::directory_iterator(out))
        printed = printed || file.path().extension() == ".pdf";
    EXPECT_TRUE(printed);
    EXPECT_TRUE(fs::exists(out / "SHA256SUMS"));
}

}  // namespace
}  // namespace leitstand::test
