#include "app/window/live/live_application.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <QApplication>
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QEventLoop>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

#include "app/language/language.h"
#include "app/report/pdf/pdf_report.h"
#include "app/services/handin/writing/report_folder.h"
#include "app/services/handin/writing/report_messages.h"
#include "app/services/handin/writing/report_writer.h"
#include "app/services/recorded/carried_map.h"
#include "app/services/station/choose_robots.h"
#include "app/services/station/last_station.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/live/demo_robots.h"
#include "app/window/live/live_window.h"
#include "app/window/live/mission/mission_feature.h"
#include "app/window/live/preflight/preflight_feature.h"
#include "app/window/robots/measures_feature.h"
#include "app/window/shell/first_geometry.h"
#include "app/window/shell/picture_size.h"
#include "app/window/shell/terminal.h"
#include "app/window/shell/work_in_front.h"
#include "app/window/source/live_bridge.h"
#include "core/event/status_samples.h"
#include "core/mission/state/mission_state.h"
#include "core/version/version.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds Patience(60);  ///< time for a screenshot to show everything
constexpr std::chrono::seconds WholeMap(5);   ///< further time for its map to be drawn completely
constexpr std::chrono::minutes Recent(30);    ///< a mission that ended within it may be the one meant
constexpr auto Explores = "explore";          ///< mode of a robot that explores by itself

void complain(const std::string& text) {
    printProblem(text);
}

fs::path under(QStandardPaths::StandardLocation place, const QString& name) {
    return fs::path(QStandardPaths::writableLocation(place).toStdString()) / "leitstand" / name.toStdString();
}

fs::path missions() {
    return under(QStandardPaths::GenericDataLocation, QStringLiteral("missions"));
}

/// Returns the folder of a new mission, named by the time.
fs::path newMission() {
    return missions() /
           QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss")).toStdString();
}

/// Returns the folder of the mission that began last on this computer. Empty when there is none.
fs::path newestMission() {
    fs::path newest;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(missions(), none)) {
        if (entry.is_directory(none) && entry.path() > newest) newest = entry.path();
    }
    return newest;
}

/// Returns @p before when it was recorded until a moment ago and @p settings do not continue it. Else empty.
fs::path interrupted(const fs::path& before, const StationSettings& settings) {
    std::error_code none;
    fs::file_time_type last = fs::file_time_type::min();
    for (const auto& file : fs::directory_iterator(before, none))
        last = std::max(last, fs::last_write_time(file.path(), none));
    const auto ago = fs::file_time_type::clock::now() - last;
    return before.empty() || before == settings.mission.folder || ago > Recent ? fs::path() : before;
}

/// Returns the message on a mission that may be meant. Empty when there is none.
QString hintAt(const fs::path& earlier) {
    if (earlier.empty()) return {};
    return QCoreApplication::translate("leitstand::Application",
                                       "%1 was recorded until a moment ago: Mission ▸ Go on with the "
                                       "mission before (or leitstand --resume)")
        .arg(QString::fromStdString(earlier.filename().string()));
}

/// Runs the event loop until @p holds. Returns false when that does not happen within @p patience.
bool waitUntil(const std::function<bool()>& holds, std::chrono::seconds patience) {
    QEventLoop loop;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (holds()) loop.quit();
    });
    look.start(100);
    QTimer::singleShot(patience, &loop, &QEventLoop::quit);
    loop.exec();
    return holds();
}

/// Runs the event loop for @p time. @p explore: its robots explore by themselves meanwhile.
void goOn(Station& station, std::chrono::seconds time, bool explore) {
    QEventLoop loop;
    QTimer again;
    QObject::connect(&again, &QTimer::timeout, &loop, [&station] {
        const MissionStatePtr mission = station.mission();
        for (const RobotDescription& robot : station.robots()) {
            const auto reported = mission->robots.find(robot.name);
            if (reported == mission->robots.end() || !reported->second->mode) continue;
            if (reported->second->mode->sample.autonomous) continue;
            station.requestGrant(robot.name);
            if (station.robot(robot.name).grant.mine) (void)station.setMode(robot.name, Explores);
        }
    });
    if (explore) again.start(500);
    QTimer::singleShot(time, &loop, &QEventLoop::quit);
    loop.exec();
}

int takePicture(LiveWindow& window, Station& station, const Options& options) {
    window.resize(windowSizeFor(options.size, window.devicePixelRatioF()));
    window.show();
    if (!waitUntil([&] { return window.missing().isEmpty(); }, Patience)) {
        complain("no picture after 60 s: " + window.missing().toStdString());
        return 1;
    }
    if (options.after > 0) goOn(station, std::chrono::seconds(options.after), options.demo);
    // A map that grows while this computer is busy is never drawn completely. The picture then shows what is
    // there.
    (void)waitUntil([&] { return window.mapView().settled(); }, WholeMap);
    QApplication::processEvents();
    if (!pictureOf(window, options.size).save(QString::fromStdString(options.screenshot))) {
        complain(options.screenshot + ": the picture could not be written");
        return 1;
    }
    return 0;
}

void remember(const LiveWindow& window, WindowState state) {
    state.liveGeometry = window.saveGeometry();
    state.liveLayout = QString::fromStdString(window.layouts().current().name);
    state.view = window.view();
    saveWindowState(state);
}

fs::path lastFile() {
    return under(QStandardPaths::GenericConfigLocation, QStringLiteral("live.yaml"));
}

Result<StationSettings> settingsOf(const Options& options, const RosEnvironment& environment,
                                   const fs::path& passing) {
    const bool picture = !options.screenshot.empty();
    auto domain = domainSettings(options.network, options.demo ? RosEnvironment{} : environment);
    if (!domain) return domain.error();
    StationSettings settings;
    settings.domain = std::move(domain).value();
    // Simulated robots concern nobody else: nothing leaves this computer unless that is requested.
    if (options.demo && settings.domain.interfaces.empty()) settings.domain.interfaces = {"lo"};
    settings.mission.title = QSysInfo::machineHostName().toStdString();
    settings.mission.version = version();
    settings.mission.folder = !options.mission.empty() ? fs::path(options.mission)
                              : picture                ? passing / "mission"
                              : options.resume         ? newestMission()
                                                       : newMission();
    settings.memory = picture ? passing / "station.yaml"
                              : under(QStandardPaths::GenericConfigLocation, QStringLiteral("station.yaml"));
    if (!picture)
        settings.alarms = under(QStandardPaths::GenericConfigLocation, QStringLiteral("alarms.yaml"));
    return settings;
}

/// How a window on the station ended.
struct Ended {
    int status = 0;
    std::string robot = {};    ///< file of a robot to add, or that was changed; empty: none
    std::string changed = {};  ///< name of the robot whose file was changed; empty: none
    QString language = {};     ///< of the next window; empty: there is none
    bool earlier = false;      ///< the mission before is to be continued
    fs::path mapOf = {};       ///< mission whose map a new mission begins in; empty: none
    QString problem = {};      ///< why there is no station; empty: there was one
};

/// Shows a window on @p bridge until it is closed, or something else is wanted. @p earlier: the mission that
/// may be meant; empty: none. @p hint: shown at once.
Ended showWindow(LiveBridge& bridge, const Options& options, DemoRobots* demo, const fs::path& earlier,
                 const QString& hint) {
    const bool picture = !options.screenshot.empty();
    WindowState remembered = picture ? WindowState{} : loadWindowState();
    if (options.look) remembered.view.look = *options.look;
    if (options.theme) remembered.view.theme = *options.theme;
    PadMemory pads(picture ? fs::path()
                           : under(QStandardPaths::GenericConfigLocation, QStringLiteral("pads")));
    LiveWindow window(bridge, remembered.view, {}, std::move(pads));
    if (!options.layout.empty() && !window.layouts().begin(QString::fromStdString(options.layout)))
        return complain("--layout " + window.newest().toStdString()), Ended{2};
    if (options.look) window.setLook(*options.look);
    if (demo != nullptr) {
        QObject::connect(demo, &DemoRobots::failed, &window, &LiveWindow::showMessage);
        demo->start();
    }
    if (picture) return {takePicture(window, bridge.station(), options)};
    Ended ended;
    if (!earlier.empty()) window.mission().offerEarlier(QString::fromStdString(earlier.filename().string()));
    if (!hint.isEmpty()) window.showMessage(hint);
    QObject::connect(&window.mission(), &MissionFeature::earlierWanted, &window, [&] {
        ended.earlier = true;
        window.closeUnasked();
    });
    QObject::connect(&window.mission(), &MissionFeature::mapWanted, &window, [&](const QString& folder) {
        ended.mapOf = folder.toStdString();
        window.closeUnasked();
    });
    QObject::connect(&window.preflight(), &PreflightFeature::robotWanted, &window, [&](const QString& file) {
        ended.robot = file.toStdString();
        window.closeUnasked();
    });
    QObject::connect(&window.measures(), &MeasuresFeature::fileChanged, &window,
                     [&](const QString& robot, const QString& file) {
                         ended.changed = robot.toStdString();
                         ended.robot = file.toStdString();
                         window.closeUnasked();
                     });
    QObject::connect(&window, &LiveWindow::languageWanted, &window, [&](const QString& code) {
        ended.language = remembered.language = code;
        window.closeUnasked();
    });
    if (demo == nullptr) window.preflight().openWhenSomethingFails();
    if (options.layout.empty() && !remembered.liveLayout.isEmpty()) {
        window.layouts().begin(remembered.liveLayout);
        if (options.look) window.setLook(*options.look);
    }
    QObject::connect(&window, &LiveWindow::closing, &window, [&] { remember(window, remembered); });
    showAsLeft(window, remembered.liveGeometry, remembered.firstSize);
    ended.status = QApplication::exec();
    return ended;
}

/// Shows windows on the station of @p settings until one is closed, or another robot or mission is wanted.
/// Once the station records, prints the mission's folder, unless it was the last one printed.
Ended showStation(const StationSettings& settings, const Options& options, DemoRobots* demo,
                  const fs::path& earlier, QString hint, fs::path& printed) {
    auto bridge = LiveBridge::open(settings);
    if (!bridge) {
        complain(bridge.error().text);
        return {.status = 1, .problem = QString::fromStdString(bridge.error().text)};
    }
    if (options.screenshot.empty() &&
        std::exchange(printed, settings.mission.folder) != settings.mission.folder)
        printNotice("the mission is recorded into " + settings.mission.folder.string());
    // For another language the window is created again. Robots, mission and the driver's grants stay.
    while (true) {
        Ended ended = showWindow(**bridge, options, demo, earlier, std::exchange(hint, {}));
        if (ended.language.isEmpty()) return ended;
        useLanguage(ended.language);
    }
}

/// Copies the map of the mission @p from into the new one of @p settings. Returns an error in words; empty:
/// none.
QString carryInto(const StationSettings& settings, const fs::path& from) {
    QString problem;
    workInFront(
        {.name = QStringLiteral("carrying"),
         .label = QCoreApplication::translate("leitstand::Application", "The map of %1 is being copied.")
                      .arg(QDir(QString::fromStdString(from.string())).dirName())},
        [&](const Progress& progress) {
            try {
                const auto carried = carryMap(
                    from, {settings.mission.folder, settings.mission.robots, settings.mission.version},
                    progress);
                if (!carried) problem = QString::fromStdString(carried.error().text);
            } catch (const std::exception& broken) {  // out of memory
                problem = QString::fromUtf8(broken.what());
            }
        });
    return problem;
}

/// Adds to the judges' folder of @p mission what came since it was last written. Does nothing when there is
/// none.
void handInLast(const fs::path& mission, const std::string& version) {
    const fs::path out = reportFolderOf(mission);
    if (out.empty()) return;
    ReportOptions options;
    options.pdf = &pdfOf;
    options.version = version;
    const auto done = writeReport(mission, out, options);
    for (const std::string& text : ReportMessages().of(done, out)) complain(text);
}

}  // namespace

std::optional<Options> lastOptions() {
    const auto last = lastStation(lastFile());
    if (!last) return std::nullopt;
    Options options;
    options.live = true;
    options.robots = last->robots;
    options.network.domain = last->domain;
    options.network.interfaces = last->interfaces;
    options.network.initialPeers = last->initialPeers;
    options.network.discoveryServer = last->discoveryServer;
    options.network.keys = last->keys;
    return options;
}

int runLive(const Options& options, const RosEnvironment& environment) {
    std::vector<std::string> files =
        options.robots.empty() ? std::vector<std::string>{"kurt3d", "crawler"} : options.robots;
    const QTemporaryDir passing;  // holds the mission of a screenshot, which is not kept
    const fs::path before = newestMission();
    auto chosen = settingsOf(options, environment, passing.path().toStdString());
    if (!chosen) return complain(chosen.error().text), 1;
    StationSettings settings = std::move(chosen).value();
    if (settings.mission.folder.empty())
        return complain("--resume: no mission was recorded so far into " + missions().string()), 1;
    std::optional<DemoRobots> demo;
    if (options.demo) {
        DemoSettings simulated;
        simulated.domain = settings.domain.domain;
        simulated.interface = QString::fromStdString(settings.domain.interfaces.front());
        demo.emplace(simulated);
        QObject::connect(&*demo, &DemoRobots::failed,
                         [](const QString& why) { complain(why.toStdString()); });
    }
    std::set<fs::path> recorded;
    fs::path printed;  // folder that was printed last
    fs::path earlier = interrupted(before, settings);
    QString hint = hintAt(earlier);
    bool switched = false;  // from another mission, now the earlier one
    fs::path mapOf = options.mapOf, beforeIt;
    // For each robot that the operator adds, the station opens again and continues its mission.
    while (true) {
        auto robots = chooseRobots(files);
        if (!robots) return complain(robots.error().text), 1;
        settings.mission.robots = std::move(robots).value();
        if (!mapOf.empty()) {
            const QString problem = carryInto(settings, std::exchange(mapOf, {}));
            if (!problem.isEmpty() && recorded.empty()) return complain(problem.toStdString()), 1;
            if (!problem.isEmpty()) {
                settings.mission.folder = std::exchange(earlier, beforeIt);
                hint = problem;
            }
        }
        if (!options.demo && options.screenshot.empty())
            rememberStation(lastFile(), {files, options.network.domain, options.network.interfaces,
                                         options.network.initialPeers, options.network.discoveryServer,
                                         options.network.keys.string()});
        const Ended ended = showStation(settings, options, demo ? &*demo : nullptr, earlier,
                                        std::exchange(hint, {}), printed);
        const bool opened = ended.problem.isEmpty();
        if (opened) recorded.insert(settings.mission.folder);
        if (ended.earlier || (switched && !opened)) {
            std::swap(settings.mission.folder, earlier);
            // When a mission cannot be continued, the station returns to the one it had.
            if (!opened) earlier.clear();
            hint = ended.problem;
            switched = ended.earlier;
        } else if (!ended.changed.empty()) {
            useFile(files, settings.mission.robots, ended.changed, ended.robot);
        } else if (!ended.robot.empty()) {
            files.push_back(ended.robot);
        } else if (!ended.mapOf.empty()) {
            mapOf = ended.mapOf;
            beforeIt = earlier;
            earlier = std::exchange(settings.mission.folder, newMission());
        } else {
            if (ended.status != 0) return ended.status;  // the mission may be another station's
            for (const fs::path& mission : recorded) handInLast(mission, settings.mission.version);
            return 0;
        }
    }
}

}  // namespace leitstand
