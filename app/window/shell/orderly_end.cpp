#include "app/window/shell/orderly_end.h"

#include <QApplication>
#include <QWidget>

#include "app/window/shell/asks_before_closing.h"

namespace leitstand {
namespace {

void closeAll() {
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (auto* asks = dynamic_cast<AsksBeforeClosing*>(window)) asks->closeUnasked();
    }
    QApplication::closeAllWindows();
    QApplication::exit();
}

}  // namespace

OrderlyEnd::OrderlyEnd(QObject* parent)
    : QObject(parent), m_interrupt(InterruptGuard::End::Surely), m_came(m_interrupt.token(), [this] {
          QMetaObject::invokeMethod(this, &closeAll, Qt::QueuedConnection);
      }) {}

}  // namespace leitstand
