#include "app/window/review/review_application.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <QApplication>
#include <QEventLoop>
#include <QTimer>

#include "app/language/language.h"
#include "app/services/recorded/review_log.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/review/by_hand/by_hand.h"
#include "app/window/review/merge_progress.h"
#include "app/window/review/review_window.h"
#include "app/window/scans/scans_window.h"
#include "app/window/shell/first_geometry.h"
#include "app/window/shell/orderly_end.h"
#include "app/window/shell/picture_size.h"
#include "app/window/shell/terminal.h"
#include "app/window/source/review_bridge.h"
#include "app/window/source/review_report.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Patience(60);  ///< time for a screenshot to show everything

void complain(const std::string& text) {
    printProblem(text);
}

/// Runs the event loop until @p holds. Returns false after Patience, which starts again with each progress in
/// opening @p bridge: clouds may have to be registered.
template <class Holds>
bool waitUntil(ReviewBridge& bridge, Holds holds) {
    QEventLoop loop;
    QTimer look, patience;
    patience.setSingleShot(true);
    QObject::connect(&patience, &QTimer::timeout, &loop, &QEventLoop::quit);
    QObject::connect(&bridge, &ReviewBridge::opening, &patience, [&] { patience.start(Patience); });
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (holds()) loop.quit();
    });
    look.start(100);
    patience.start(Patience);
    loop.exec();
    return holds();
}

int takePicture(ReviewBridge& bridge, ReviewWindow& window, const Options& options) {
    window.resize(windowSizeFor(options.size, window.devicePixelRatioF()));
    window.show();
    bridge.player().seek(bridge.player().last());  // the first moment shown is not the beginning
    // The last moment with robots shows most of a mission: all of its map.
    std::optional<Time> wanted;
    const bool shown = waitUntil(bridge, [&] {
        if (bridge.index() && !wanted) {
            wanted = bridge.index()->lastReceived;
            bridge.player().seek(*wanted);
        }
        return bridge.reviewed() && wanted && bridge.reviewed()->now >= *wanted && window.missing().isEmpty();
    });
    if (!shown) {
        complain("no picture after 60 s: " + window.missing().toStdString());
        return 1;
    }
    QApplication::processEvents();
    if (!pictureOf(window, options.size).save(QString::fromStdString(options.screenshot))) {
        complain(options.screenshot + ": the picture could not be written");
        return 1;
    }
    return 0;
}

/// What follows a window on a review. Empty: it was closed.
struct Next {
    QString language;                   ///< of the next window
    std::optional<MapTidying> tidying;  ///< tidying, and the review again after it
    bool byHand = false;                ///< decisions on its map, and the review again after them
    std::filesystem::path merging;      ///< mission to merge its map with; the result is reviewed then
};

/// Shows a window on @p bridge until it is closed, with @p text as its first message.
int showWindow(ReviewBridge& bridge, const Options& options, const QString& text, Next& next) {
    const bool picture = !options.screenshot.empty();
    WindowState remembered = picture ? WindowState{} : loadWindowState();
    if (options.look) remembered.view.look = *options.look;
    if (options.theme) remembered.view.theme = *options.theme;
    remembered.view.follow = MapFollow::Free;
    ReviewWindow window(bridge, remembered.view);
    if (!options.layout.empty() && !window.layouts().begin(QString::fromStdString(options.layout)))
        return complain("--layout " + window.newest().toStdString()), 2;
    if (options.look) window.setLook(*options.look);
    if (picture) return takePicture(bridge, window, options);
    QObject::connect(&window, &ReviewWindow::registerAgainWanted, &window,
                     [&] { showScansWindow({bridge.player().folder()}, loadWindowState()); });
    QObject::connect(&window, &ReviewWindow::languageWanted, &window, [&](const QString& code) {
        next.language = remembered.language = code;
        window.close();
        QCoreApplication::exit(0);  // another window may be registering: it stays
    });
    QObject::connect(&window, &ReviewWindow::tidyingWanted, &window, [&](MapTidying what) {
        next.tidying = what;
        window.close();
        QCoreApplication::exit(0);
    });
    QObject::connect(&window, &ReviewWindow::byHandWanted, &window, [&] {
        next.byHand = true;
        window.close();
        QCoreApplication::exit(0);
    });
    QObject::connect(&window, &ReviewWindow::mergingWanted, &window, [&](const QString& other) {
        next.merging = other.toStdString();
        window.close();
        QCoreApplication::exit(0);
    });
    QObject::connect(&window, &ReviewWindow::closing, &window, [&] {
        remembered.liveGeometry = window.saveGeometry();
        remembered.view = window.view();
        saveWindowState(remembered);
    });
    showAsLeft(window, remembered.liveGeometry, remembered.firstSize);
    if (!text.isEmpty()) window.showMessage(text);
    return QApplication::exec();
}

/// Tidies the mission of @p bridge, which was opened as @p source, and opens the review again at the same
/// time. Shows the finished map when something moved.
Result<std::unique_ptr<ReviewBridge>> tidied(std::unique_ptr<ReviewBridge> bridge,
                                             const std::filesystem::path& source, MapTidying what,
                                             QString& text) {
    const std::filesystem::path folder = bridge->player().folder();
    const Time position = bridge->player().position();
    const ReviewMap map = bridge->player().map();
    bridge.reset();  // what was written in it is in the mission
    const TidyingOutcome outcome = tidyInFront(folder, what);
    text = outcome.text;
    auto again = ReviewBridge::open(source);
    if (!again) return again;
    (*again)->player().show(outcome.moved ? ReviewMap::Finished : map);
    (*again)->player().seek(position);
    return again;
}

/// Opens the map of the mission of @p bridge, which was opened as @p source, for decisions by hand. Then
/// opens the review again at the same time. Shows the finished map when something was decided.
Result<std::unique_ptr<ReviewBridge>> corrected(std::unique_ptr<ReviewBridge> bridge,
                                                const std::filesystem::path& source, QString& text) {
    const std::filesystem::path folder = bridge->player().folder();
    const Time position = bridge->player().position();
    const ReviewMap map = bridge->player().map();
    bridge.reset();  // what was written in it is in the mission
    const ByHandOutcome outcome = correctByHand(folder);
    text = outcome.text;
    auto again = ReviewBridge::open(source);
    if (!again) return again;
    (*again)->player().show(outcome.decided ? ReviewMap::Finished : map);
    (*again)->player().seek(position);
    return again;
}

/// Merges the mission of @p bridge, which was opened as @p source, with @p other. Opens the review of the new
/// mission, which becomes @p source, or the same review when there is none.
Result<std::unique_ptr<ReviewBridge>> merged(std::unique_ptr<ReviewBridge> bridge,
                                             std::filesystem::path& source,
                                             const std::filesystem::path& other, QString& text) {
    const std::filesystem::path folder = bridge->player().folder();
    const Time position = bridge->player().position();
    bridge.reset();  // what was written in it is in the mission
    const MergingOutcome outcome = mergeInFront(folder, other);
    text = outcome.text;
    if (!outcome.mission.empty()) source = outcome.mission;
    auto opened = ReviewBridge::open(source);
    if (opened && outcome.mission.empty()) (*opened)->player().seek(position);
    return opened;
}

}  // namespace

bool wantsReview(const Options& options) {
    return !options.registerAgain && options.scans.size() == 1 && isReviewable(options.scans.front());
}

int runReview(const Options& options) {
    std::filesystem::path source = options.scans.front();
    auto bridge = ReviewBridge::open(source);
    if (!bridge) return complain(bridge.error().text), 1;
    QString text;
    while (true) {
        Next next;
        const int status = showWindow(**bridge, options, std::exchange(text, {}), next);
        if (next.tidying) {
            bridge = tidied(std::move(bridge).value(), source, *next.tidying, text);
            if (!bridge) return complain(text.toStdString() + "; " + bridge.error().text), 1;
        } else if (next.byHand) {
            bridge = corrected(std::move(bridge).value(), source, text);
            if (!bridge) return complain(text.toStdString() + "; " + bridge.error().text), 1;
        } else if (!next.merging.empty()) {
            bridge = merged(std::move(bridge).value(), source, next.merging, text);
            if (!bridge) return complain(text.toStdString() + "; " + bridge.error().text), 1;
        } else if (!next.language.isEmpty()) {
            (*bridge)->report().beginAround([&] { useLanguage(next.language); });
        } else {
            return status;
        }
        if (OrderlyEnd::asked()) return status;
    }
}

}  // namespace leitstand
