#include "app/window/shell/orderly_end.h"

#include <atomic>

#include <QApplication>
#include <QWidget>

#include "app/window/shell/asks_before_closing.h"

namespace leitstand {
namespace {

std::atomic<bool> wasAsked = false;

void closeAll() {
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (auto* asks = dynamic_cast<AsksBeforeClosing*>(window)) asks->closeUnasked();
    }
    QApplication::closeAllWindows();
    QApplication::exit();
}

}  // namespace

bool OrderlyEnd::asked() {
    return wasAsked;
}

OrderlyEnd::OrderlyEnd(QObject* parent)
    : QObject(parent), m_interrupt(InterruptGuard::End::Surely), m_came(m_interrupt.token(), [this] {
          wasAsked = true;
          QMetaObject::invokeMethod(this, &closeAll, Qt::QueuedConnection);
      }) {}

}  // namespace leitstand
