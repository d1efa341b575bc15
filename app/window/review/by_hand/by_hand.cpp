#include "app/window/review/by_hand/by_hand.h"

#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include <QApplication>
#include <QStringList>
#include <QThread>

#include "app/window/review/by_hand/by_hand_bridge.h"
#include "app/window/review/by_hand/by_hand_window.h"
#include "app/window/shell/first_geometry.h"
#include "app/window/shell/window_state.h"
#include "app/window/shell/work_in_front.h"

namespace leitstand {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ByHandWindow)
};

void showUntilClosed(ByHandBridge& bridge) {
    WindowState remembered = loadWindowState();
    remembered.view.follow = MapFollow::Free;
    ByHandWindow window(bridge, remembered.view);
    QObject::connect(&window, &ByHandWindow::closing, &window, [&] {
        remembered.liveGeometry = window.saveGeometry();
        remembered.view = window.view();
        saveWindowState(remembered);
        QCoreApplication::exit(0);  // another window may be registering: it stays
    });
    showAsLeft(window, remembered.liveGeometry, remembered.firstSize);
    QApplication::exec();
}

}  // namespace

ByHandOutcome correctByHand(const std::filesystem::path& mission) {
    std::optional<Result<std::unique_ptr<ByHandBridge>>> opened;
    workInFront({.name = QStringLiteral("openingByHand"),
                 .label = Words::tr("The map is made ready to be corrected."),
                 .cancellable = false},
                [&, gui = QThread::currentThread()](const Progress&) {
                    try {
                        opened = ByHandBridge::open(mission);
                        if (*opened) (**opened)->moveToThread(gui);
                    } catch (const std::exception& problem) {  // out of memory
                        opened = Error{problem.what()};
                    }
                });
    if (!*opened) return {false, QString::fromStdString(opened->error().text)};
    ByHandBridge& bridge = **opened.value();
    showUntilClosed(bridge);
    QStringList messages;  // messages of work that was still being done
    const auto listens = QObject::connect(&bridge, &MomentSource::notified, qApp,
                                          [&messages](const QString& text) { messages += text; });
    Result<void> closed;
    workInFront({.name = QStringLiteral("closingByHand"),
                 .label = Words::tr("The map follows what was decided. The review opens again then."),
                 .cancellable = false},
                [&](const Progress&) { closed = bridge.hand().close(); });
    QObject::disconnect(listens);
    ByHandOutcome outcome;
    outcome.decided = bridge.hand().decided();
    if (!closed)
        outcome.text = QString::fromStdString(closed.error().text);
    else if (outcome.decided)
        outcome.text = Words::tr("The map is as it was left by hand");
    if (closed && !messages.isEmpty()) outcome.text = messages.join(QStringLiteral("; "));
    return outcome;
}

}  // namespace leitstand
