#include "tests/compat/open_window.h"

#include <chrono>
#include <stdexcept>

#include <QApplication>
#include <QMainWindow>
#include <QTest>
#include <QTimer>

#include "app/window/shell/asks_before_closing.h"

namespace leitstand::test {
namespace {

constexpr std::chrono::minutes Patience(1);

QMainWindow* shownWindow() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* window = qobject_cast<QMainWindow*>(widget);
        if (window != nullptr && window->isVisible()) return window;
    }
    return nullptr;
}

void closeUnasked(QMainWindow& window) {
    if (auto* asking = dynamic_cast<AsksBeforeClosing*>(&window)) {
        asking->closeUnasked();
    } else {
        window.close();
    }
}

}  // namespace

int whileOpen(const std::function<int()>& run, const std::function<void(QMainWindow&)>& look) {
    bool looked = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        QMainWindow* const window = shownWindow();
        if (looked || window == nullptr) return;
        looked = true;  // waiting below, the timer goes on
        if (QTest::qWaitForWindowExposed(window)) look(*window);
        closeUnasked(*window);
    });
    timer.start(20);
    QTimer patience;
    patience.setSingleShot(true);
    QObject::connect(&patience, &QTimer::timeout, [&] {
        if (!looked) QCoreApplication::exit(-1);
    });
    patience.start(Patience);
    const int status = run();
    return looked ? status : -1;
}

QMainWindow& panesOf(const QMainWindow& window) {
    auto* const panes = window.findChild<QMainWindow*>();
    if (panes == nullptr) throw std::runtime_error("the window has no panes");
    return *panes;
}

}  // namespace leitstand::test
