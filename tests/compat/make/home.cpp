#include <chrono>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QTest>

#include "app/services/handin/writing/report_folder.h"
#include "app/services/layouts/layout_book.h"
#include "app/services/pad/pad_memory.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/live/live_application.h"
#include "app/window/live/live_window.h"
#include "app/window/review/review_application.h"
#include "app/window/review/review_window.h"
#include "app/window/scans/scans_window.h"
#include "app/window/shell/window_state.h"
#include "core/io/robot/brake_file.h"
#include "core/io/robot/robot_file.h"
#include "core/io/settings/layout_file.h"
#include "tests/compat/make/fixtures.h"
#include "tests/compat/open_window.h"
#include "tests/compat/shown_docks.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

void must(bool done, const std::string& what) {
    if (!done) throw std::runtime_error("failed: " + what);
}

QDockWidget& dock(const QMainWindow& panes, const char* name) {
    auto* const found = panes.findChild<QDockWidget*>(QLatin1String(name));
    if (found == nullptr) throw std::runtime_error(std::string("there is no pane ") + name);
    return *found;
}

void show(const QMainWindow& panes, const char* name) {
    dock(panes, name).show();
    dock(panes, name).raise();
}

void floatAt(const QMainWindow& panes, const char* name, const QRect& place) {
    show(panes, name);
    dock(panes, name).setFloating(true);
    dock(panes, name).setGeometry(place);
}

void tab(QMainWindow& panes, const char* host, const char* guest) {
    show(panes, guest);
    panes.tabifyDockWidget(&dock(panes, host), &dock(panes, guest));
}

/// Lets Qt lay out what was moved.
void settle() {
    QTest::qWait(300);
}

void writeRobots(const fs::path& config) {
    RobotDescription robot = readRobot(fs::path(sourceFolder()) / "resources/robots/turtlebot.yaml").value();
    robot.name = "tb9";
    robot.title = "My TurtleBot";
    robot.height = 0.2;
    robot.maxSpeed = 0.21;
    fs::create_directories(config / "robots");
    writeText(config / "robots/tb9.yaml", writeRobot(robot));
    BrakeResult passed{.verdict = BrakeResult::Verdict::Passed, .seconds = 0.31, .metres = 0.024};
    passed.when = Time(std::chrono::seconds(1'795'611'641));
    passed.watchdog = BrakeResult::Watchdog::Stops;
    passed.brakesAfter = 0.21;
    BrakeResult failed{.verdict = BrakeResult::Verdict::Failed, .seconds = 1.5, .metres = 0.151};
    failed.when = Time(std::chrono::seconds(1'795'611'941));
    failed.watchdog = BrakeResult::Watchdog::None;
    must(writeBrakes(config / "brakes.yaml", {{"kurt3d", passed}, {"tb9", failed}}).ok(), "brakes");
}

void writePads(const fs::path& config) {
    PadBindings bindings = defaultBindings(PadLayout::Standard);
    bindings.deadZone = 0.2;
    bindings.expo = 0.7;
    bindings.press = 0.6;
    bindings.cameraRate = 0.9;
    must(bindPad(bindings, PadAction::Forward, padAxis(3, -1)), "pad");
    must(bindPad(bindings, PadAction::Turbo, padAxis(4, 1, -1.0)), "pad");
    must(bindPad(bindings, std::string("view.swap"), padButton(9)), "pad");
    PadMemory pads(config / "pads");
    must(pads.keep("030000005e0400008e02000010010000", "Xbox 360 Controller", bindings).ok(), "pad");
    PadBindings plain = defaultBindings(PadLayout::Plain);
    must(bindPad(plain, PadAction::DeadMan, padButton(0)), "pad");
    must(bindPad(plain, PadAction::Forward, padAxis(1, -1)), "pad");
    must(pads.keep("0300000079000000", "Plain joystick", plain).ok(), "pad");
}

/// What operators write by hand.
void writeByHand(const fs::path& config) {
    writeText(config / "alarms.yaml",
              "# of the red arena\nco2: 900\nattitude: 61\nattitude_act: 81\nbattery_minutes: 12\n"
              "battery_minutes_act: 4\nbattery: 25\nbattery_act: 9\nstop_unanswered: 3\nfrozen_picture: 2.5\n"
              "clock: 1.5\n");
    fs::create_directories(config / "scoring");
    std::string profile = readText(fs::path(sourceFolder()) / "resources/scoring/2019.json");
    for (const auto& [from, to] :
         {std::pair("\"2019\"", "\"club\""), std::pair("\"minutes\": 23", "\"minutes\": 17")})
        profile.replace(profile.find(from), std::string(from).size(), to);
    writeText(config / "scoring/club.json", profile);
}

/// No value is the default.
WindowState changedState() {
    WindowState state;
    state.language = QStringLiteral("de");
    state.view.look = MapLook::Voxels;
    state.view.colouring = MapColouring::Height;
    state.view.theme = Theme::Light;
    state.view.voxelSize = 0.15;
    RegistrationSettings& registration = state.registration;
    registration.minimizer = Minimizer::Svd;
    registration.search = SearchMethod::Approximate;
    registration.filter = ScanFilter::Median;
    registration.guess = GuessSource::Identity;
    registration.reference = Reference::Map;
    registration.epsilon = 0.75;
    registration.reduce = 0.08;
    registration.minRange = 0.6;
    registration.maxRange = 22.0;
    registration.maxIterations = 120;
    registration.threads = 2;
    registration.maxDistances = {2.0, 1.0, 0.4};
    state.recent = {{"/home/operator/scans/hall", "/home/operator/scans/stairs"},
                    {"/home/operator/yellow-7"}};
    return state;
}

void useScansWindow(const fs::path& notes) {
    saveWindowState(changedState());
    const auto run = [] {
        showScansWindow({}, loadWindowState());
        return QApplication::exec();
    };
    must(whileOpen(run,
                   [&](QMainWindow& window) {
                       window.setGeometry(120, 90, 1500, 880);
                       window.addDockWidget(Qt::LeftDockWidgetArea, &dock(window, "registrationDock"));
                       settle();
                       window.resizeDocks({&dock(window, "registrationDock")}, {430}, Qt::Horizontal);
                       floatAt(window, "scansDock", {700, 300, 520, 360});
                       settle();
                       std::ofstream out(notes / "scans-window.txt");
                       for (const std::string& line : shownDocks(window)) out << line << '\n';
                   }) == 0,
         "the scans window");
}

/// Keeps how the panes are as a layout called @p title.
void save(QMainWindow& panes, LayoutFeature& layouts, const char* title, const fs::path& notes) {
    settle();
    const auto shown = shownDocks(panes);
    must(layouts.saveAs(QString::fromUtf8(title)), title);
    std::ofstream out(notes / (layouts.current().name + ".txt"));
    for (const std::string& line : shown) out << line << '\n';
}

void arrangeLive(LiveWindow& window, const fs::path& notes) {
    PaneDocks& panes = window.panes();
    LayoutFeature& layouts = window.layouts();
    must(layouts.use("drive"), "drive");
    panes.setArranging(true);
    tab(panes, "map", "scan");
    tab(panes, "alarms", "messages");
    show(panes, "map");
    dock(panes, "victims").close();
    floatAt(panes, "link", {240, 260, 640, 480});
    panes.addDockWidget(Qt::RightDockWidgetArea, &dock(panes, "right"));
    panes.resizeDocks({&dock(panes, "camera"), &dock(panes, "map")}, {700, 500}, Qt::Horizontal);
    save(panes, layouts, "Bench, left desk", notes);
    panes.setArranging(false);

    must(layouts.use("drive"), "drive");
    window.findChild<QAction*>("view.swap")->trigger();
    save(panes, layouts, "Swapped", notes);

    must(layouts.use("map"), "map");
    panes.setArranging(true);
    show(panes, "missed");
    panes.addDockWidget(Qt::BottomDockWidgetArea, &dock(panes, "missed"));
    tab(panes, "missed", "score");
    tab(panes, "missed", "victims");
    floatAt(panes, "camera", {1000, 500, 480, 360});
    floatAt(panes, "form", {300, 200, 480, 640});
    save(panes, layouts, "Plan überall", notes);
    panes.setArranging(false);
    must(layouts.use("bench-left-desk"), "bench-left-desk");
}

void useLiveWindow(const fs::path& mission, const fs::path& notes) {
    Options options;
    options.live = true;
    options.robots = {"kurt3d", "tb9"};
    options.network.domain = 87;
    options.network.interfaces = {"lo"};
    options.mission = mission.string();
    must(whileOpen([&] { return runLive(options); },
                   [&](QMainWindow& window) {
                       window.setGeometry(60, 40, 1600, 960);
                       settle();
                       arrangeLive(dynamic_cast<LiveWindow&>(window), notes);
                   }) == 0,
         "the live window");
}

/// Keys and buttons are the operator's to write into a layout's file.
void bindByHand(const fs::path& file) {
    WindowLayout layout = readLayout(file).value();
    layout.keys = {{"view.swap", "Ctrl+K"}, {"layout.arrange", "Ctrl+Shift+A"}};
    layout.pad = {{"x", "camera.recentre"}, {"y", "view.swap"}};
    must(saveLayout(layout, file).ok(), "keys of a layout");
}

void useReviewWindow(const fs::path& mission, const fs::path& notes) {
    Options options;
    options.scans = {mission};
    const auto arrange = [&](QMainWindow& shown) {
        auto& window = dynamic_cast<ReviewWindow&>(shown);
        window.setGeometry(60, 40, 1600, 960);
        PaneDocks& panes = window.panes();
        must(window.layouts().use("review"), "review");
        settle();
        panes.setArranging(true);
        tab(panes, "finds", "form");
        tab(panes, "strip", "score");
        floatAt(panes, "compare", {500, 300, 700, 420});
        dock(panes, "camera").close();
        save(panes, window.layouts(), "Jury", notes);
        panes.setArranging(false);
    };
    must(whileOpen([&] { return runReview(options); }, arrange) == 0, "the review window");
}

}  // namespace

void makeHome(const fs::path& home, const fs::path& mission) {
    const fs::path config = home / ".config/leitstand", notes = home / "panes";
    fs::create_directories(config);
    fs::create_directories(notes);
    writeRobots(config);
    writePads(config);
    writeByHand(config);
    useScansWindow(notes);
    must(keepReportFolder(mission, {}).ok(), "no hand-in meanwhile");
    useLiveWindow(mission, notes);
    bindByHand(config / "layouts/bench-left-desk.yaml");
    useReviewWindow(mission, notes);
}

}  // namespace leitstand::test
