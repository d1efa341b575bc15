// Names that users, their files and other programs rely on: those of the lists must be there. New ones may
// come, and are then added to the lists; none is ever taken out.
#include <csignal>
#include <set>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QAction>
#include <QApplication>
#include <QMainWindow>
#include <QTest>
#include <nlohmann/json.hpp>

#include "app/window/live/live_application.h"
#include "app/window/review/review_application.h"
#include "app/window/scans/scans_window.h"
#include "tests/app/services/scan_folder.h"
#include "tests/compat/compat_home.h"
#include "tests/compat/expected.h"
#include "tests/compat/lines.h"
#include "tests/compat/open_window.h"
#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/support/process.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Names = std::set<std::string>;

/// "WINDOW ID" of every command that has a name.
void addCommands(const char* window, const QMainWindow& shown, Names& names) {
    for (const QAction* action : shown.findChildren<QAction*>()) {
        const std::string id = action->objectName().toStdString();
        if (!id.empty() && !id.starts_with("_q_") && !id.starts_with("qt_"))
            names.insert(std::string(window) + ' ' + id);
    }
}

/// The path of every key of @p value: "sessions[].file".
void addKeys(const std::string& path, const json& value, Names& names) {
    if (value.is_array()) {
        for (const json& one : value) addKeys(path + "[]", one, names);
        return;
    }
    if (!value.is_object()) return;
    for (const auto& [key, inner] : value.items()) {
        const std::string here = path + (path.ends_with(' ') ? "" : ".") + key;
        names.insert(here);
        addKeys(here, inner, names);
    }
}

/// All of @p list, a file of tests/compat, are among @p names. Names that are not in it yet are told.
void expectAllOf(const std::string& list, const Names& names) {
    const std::vector<std::string> found(names.begin(), names.end());
    std::string text;
    for (const std::string& name : found) text += name + '\n';
    (void)isAsExpected(list, text);  // keeps what was found, where that is asked for
    EXPECT_THAT(goneFrom(list, found), testing::IsEmpty()) << "gone, though " << list << " has it";
    const auto known = linesOf(compatFile(list));
    for (const std::string& name : found) {
        if (std::find(known.begin(), known.end(), name) == known.end())
            std::printf("new, to be added to tests/compat/%s: %s\n", list.c_str(), name.c_str());
    }
}

json ctl(const std::vector<std::string>& arguments) {
    const ProcessOutcome outcome = runProcess(program("leitstandctl"), arguments);
    EXPECT_EQ(outcome.exitCode, 0) << arguments.front() << ": " << outcome.err;
    return json::parse(outcome.out, nullptr, false);
}

class CompatNames : public CompatHome {
protected:
    CompatNames() { fs::remove_all(config() / "layouts"); }  // what operators named is theirs

    const TestDomain m_domain;
    const std::string m_number = std::to_string(m_domain.number());
};

TEST_F(CompatNames, CommandsAreThere) {
    Names names;
    Options options;
    options.live = true;
    options.robots = {"kurt3d", "crawler"};
    options.network.interfaces = {"lo"};
    options.network.domain = m_domain.number();
    options.mission = (m_folder / "new").string();
    EXPECT_EQ(whileOpen([&] { return runLive(options); },
                        [&](QMainWindow& window) { addCommands("live", window, names); }),
              0);
    Options review;
    review.scans = {m_mission};
    EXPECT_EQ(whileOpen([&] { return runReview(review); },
                        [&](QMainWindow& window) { addCommands("review", window, names); }),
              0);
    const auto scans = [] {
        showScansWindow({}, loadWindowState());
        return QApplication::exec();
    };
    EXPECT_EQ(whileOpen(scans, [&](QMainWindow& window) { addCommands("scans", window, names); }), 0);
    expectAllOf("command-ids.txt", names);
}

TEST_F(CompatNames, JsonOfFilesHasItsKeys) {
    Names names;
    writeDrive(m_folder / "drive", 2);
    addKeys("info ", ctl({"info", "--json", m_mission.string()}), names);
    addKeys("register ", ctl({"register", "--json", (m_folder / "drive").string()}), names);
    addKeys("register ", ctl({"register", "--close-loops", "--json", (m_folder / "drive").string()}), names);
    addKeys("export ",
            ctl({"export", "--json", m_mission.string(), "--out", (m_folder / "map.xyz").string()}), names);
    addKeys("report ",
            ctl({"report", "--json", "--no-pdf", m_mission.string(), "--out", (m_folder / "out").string()}),
            names);
    addKeys("thin ", ctl({"thin", "--json", m_mission.string(), "--out", (m_folder / "thin").string()}),
            names);
    expectAllOf("json-keys.txt", names);
}

TEST_F(CompatNames, JsonOfTheNetworkHasItsKeys) {
    Names names;
    const ChildProcess robot(program("leitstandctl"), {"replay", m_mission.string(), "--loop", "--rate",
                                                       "0.2", "--domain", m_number, "--interface", "lo"});
    addKeys("probe ",
            ctl({"probe", "--json", "--seconds", "6", "--domain", m_number, "--interface", "lo", "--out",
                 m_folder.path().string()}),
            names);
    ChildProcess recording(program("leitstandctl"),
                           {"record", "--json", "--robot", "kurt3d", "--domain", m_number, "--interface",
                            "lo", "--out", (m_folder / "recorded").string()});
    ASSERT_TRUE(QTest::qWaitFor([&] { return recording.out().find("recording domain") != std::string::npos; },
                                60'000));
    recording.signal(SIGINT);
    EXPECT_EQ(recording.wait(), 0);
    const std::string reported = recording.out();
    const std::size_t begin = reported.find("\n{") + 1, end = reported.rfind('}') + 1;
    ASSERT_LT(begin, end) << reported;
    addKeys("record ", json::parse(reported.substr(begin, end - begin), nullptr, false), names);
    expectAllOf("json-keys-network.txt", names);
}

/// What the station offers and asks for, as another participant of the domain sees it.
TEST_F(CompatNames, TheStationIsOnTheWireAsBefore) {
    Names lines;
    Options options;
    options.live = true;
    options.robots = {"kurt3d", "crawler"};
    options.network.interfaces = {"lo"};
    options.network.domain = m_domain.number();
    options.mission = (m_folder / "new").string();
    json seen;
    EXPECT_EQ(whileOpen([&] { return runLive(options); },
                        [&](QMainWindow&) {
                            std::atomic<bool> done = false;
                            const std::jthread probing([&] {
                                seen = ctl({"probe", "--json", "--seconds", "8", "--domain", m_number,
                                            "--interface", "lo", "--out", m_folder.path().string()});
                                done = true;
                            });
                            EXPECT_TRUE(QTest::qWaitFor([&] { return done.load(); }, 60'000));
                        }),
              0);
    for (const json& topic : seen.at("topics")) {
        const bool writes = topic.at("writers").get<int>() > 0, reads = topic.at("readers").get<int>() > 0;
        lines.insert(topic.at("topic").get<std::string>() + ' ' + topic.at("type").get<std::string>() +
                     (writes ? " writes" : "") + (reads ? " reads" : "") + " \"" +
                     topic.at("qos").get<std::string>() + '"');
    }
    expectAllOf("wire-of-station.txt", lines);
}

}  // namespace
}  // namespace leitstand::test
