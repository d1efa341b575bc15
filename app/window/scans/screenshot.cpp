#include "app/window/scans/screenshot.h"

#include <QApplication>
#include <QEventLoop>
#include <QTimer>

#include "app/window/scans/main_window.h"
#include "app/window/shell/picture_size.h"
#include "app/window/shell/terminal.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {
namespace {

void complain(const QString& text) {
    printProblem(text.toStdString());
}

/// Runs the event loop until all is registered and drawn. Returns false when that takes longer than @p
/// patience.
bool waitUntilShown(MainWindow& window, std::chrono::milliseconds patience) {
    QEventLoop loop;
    const auto shown = [&window] { return window.idle() && window.mapView().settled(); };
    const auto quitWhenShown = [&] {
        if (shown()) loop.quit();
    };
    QObject::connect(&window, &MainWindow::becameIdle, &loop, quitWhenShown, Qt::QueuedConnection);
    QObject::connect(&window.mapView(), &MapView::becameSettled, &loop, quitWhenShown, Qt::QueuedConnection);
    QObject::connect(&window.mapView(), &MapView::failed, &loop, &QEventLoop::quit);
    QTimer::singleShot(patience, &loop, &QEventLoop::quit);
    QMetaObject::invokeMethod(&loop, quitWhenShown, Qt::QueuedConnection);
    loop.exec();
    return shown();
}

QString whatIsMissing(const MainWindow& window, std::chrono::milliseconds patience) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(patience).count();
    const QString scans = MainWindow::tr("%1 scans are registered").arg(window.scans().rowCount());
    if (!window.idle()) {
        return MainWindow::tr("no picture: after %1 s only %2, others are not").arg(seconds).arg(scans);
    }
    return MainWindow::tr("no picture: %1, but they are not drawn after %2 s").arg(scans).arg(seconds);
}

}  // namespace

int screenshot(MainWindow& window, const Sources& scans, const QString& file,
               const std::optional<QSize>& pixels, std::chrono::milliseconds patience) {
    int status = 0;
    QObject::connect(&window, &MainWindow::failed, &window, [&status](const QString& why) {
        complain(why);
        status = 1;
    });
    window.show();
    window.open(scans);
    if (!waitUntilShown(window, patience)) {
        complain(whatIsMissing(window, patience));
        return 1;
    }
    // Panels that changed their size with the last scan are laid out before the picture is taken.
    QApplication::processEvents();
    if (!waitUntilShown(window, patience)) return 1;
    if (!pictureOf(window, pixels).save(file)) {
        complain(MainWindow::tr("%1: the picture could not be written").arg(file));
        return 1;
    }
    return status;
}

}  // namespace leitstand
