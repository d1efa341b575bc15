#include "app/window/orderly_end.h"

#include <QApplication>

namespace leitstand {
namespace {

void closeAll() {
    QApplication::closeAllWindows();
    QApplication::exit();
}

}  // namespace

OrderlyEnd::OrderlyEnd(QObject* parent)
    : QObject(parent), m_interrupt(InterruptGuard::End::Surely), m_came(m_interrupt.token(), [this] {
          QMetaObject::invokeMethod(this, &closeAll, Qt::QueuedConnection);
      }) {}

}  // namespace leitstand
