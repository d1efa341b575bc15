#include "app/window/application.h"

#include <optional>

#include <QApplication>

#include "app/language/language.h"
#include "app/window/live/live_application.h"
#include "app/window/review/review_application.h"
#include "app/window/scans/main_window.h"
#include "app/window/scans/scans_window.h"
#include "app/window/scans/screenshot.h"
#include "app/window/shell/options.h"
#include "app/window/shell/orderly_end.h"
#include "app/window/shell/picture_size.h"
#include "app/window/shell/terminal.h"
#include "core/version/version.h"

namespace leitstand {
namespace {

bool displayIsThere() {
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
}

void applyChoices(const Options& options, MapViewSettings& view) {
    if (options.look) view.look = *options.look;
    if (options.theme) view.theme = *options.theme;
}

QString languageOf(const Options& options) {
    if (!options.language.empty()) return QString::fromStdString(options.language);
    if (!options.screenshot.empty()) return languages().front().code;  // the same on every machine
    const QString remembered = loadWindowState().language;
    return remembered.isEmpty() ? systemLanguage() : remembered;
}

int takeScreenshot(const Options& options) {
    WindowState state;  // remembered settings would make pictures differ between machines
    state.firstSize = windowSizeFor(options.size, qApp->devicePixelRatio());
    applyChoices(options, state.view);
    MainWindow window(state);
    return screenshot(window, options.scans, QString::fromStdString(options.screenshot), options.size);
}

int showWindow(const Options& options) {
    WindowState state = loadWindowState();
    applyChoices(options, state.view);
    showScansWindow(options.scans, state);
    return QApplication::exec();
}

/// Returns @p options. What they leave open is taken from @p last.
Options withLast(Options options, const Options& last) {
    if (options.robots.empty()) options.robots = last.robots;
    DomainOptions& network = options.network;
    if (!network.domain) network.domain = last.network.domain;
    if (network.interfaces.empty() && network.initialPeers.empty() && network.discoveryServer.empty()) {
        network.interfaces = last.network.interfaces;
        network.initialPeers = last.network.initialPeers;
        network.discoveryServer = last.network.discoveryServer;
    }
    if (network.keys.empty()) network.keys = last.network.keys;
    options.live = true;
    return options;
}

}  // namespace

int runStation(int argc, char** argv) {
    const auto parsed = parseOptions(argc, argv);
    if (const int* status = std::get_if<int>(&parsed)) return *status;
    const Options& options = std::get<Options>(parsed);
    const auto environment = rosEnvironment();  // before anything has threads
    const bool picture = !options.screenshot.empty();
    if (picture) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    } else if (!displayIsThere()) {
        printProblem("there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set).");
        printProblem("To get a picture without one: leitstand --screenshot map.png SCANS...");
        return 1;
    }
    printQtMessages(picture);
    QApplication application(argc, argv);
    QGuiApplication::setDesktopFileName(
        QStringLiteral("org.leitstand.leitstand"));  // its icon, under Wayland
    QApplication::setApplicationName(QStringLiteral("leitstand"));
    QApplication::setApplicationVersion(QString::fromLatin1(version()));
    useLanguage(languageOf(options));
    std::optional<OrderlyEnd> end;
    if (!picture) end.emplace();
    const auto onRobots = [&](const Options& chosen) {
        if (environment || chosen.demo) return runLive(chosen, environment ? *environment : RosEnvironment{});
        printProblem(environment.error().text);
        return 1;
    };
    if (options.live) return onRobots(options);
    if (argc == 1 || options.resume) {
        const auto last = lastOptions();
        if (last || options.resume) return onRobots(withLast(options, last.value_or(Options{})));
    }
    if (wantsReview(options)) return runReview(options);
    return picture ? takeScreenshot(options) : showWindow(options);
}

}  // namespace leitstand
