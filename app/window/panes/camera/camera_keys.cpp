#include "app/window/panes/camera/camera_keys.h"

#include <utility>

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include "app/window/input/worked_in.h"
#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr double Fast = degrees(60), Slow = degrees(15);  ///< [rad/s]

}  // namespace

CameraKeys::CameraKeys(QWidget& window, std::function<bool()> driving)
    : QObject(&window), m_window(window), m_driving(std::move(driving)) {
    qApp->installEventFilter(this);
}

QString CameraKeys::names() {
    return tr("Q E PgUp PgDn");
}

std::optional<CameraKeys::Way> CameraKeys::wayOf(const QKeyEvent& event) {
    const bool pad = event.modifiers().testFlag(Qt::KeypadModifier);
    switch (event.key()) {
        case Qt::Key_Q:
            return Way::Left;
        case Qt::Key_E:
            return Way::Right;
        case Qt::Key_PageUp:
            return Way::Up;
        case Qt::Key_PageDown:
            return Way::Down;
        default:
            break;
    }
    if (!pad) return std::nullopt;
    switch (event.key()) {
        case Qt::Key_4:
        case Qt::Key_Left:
            return Way::Left;
        case Qt::Key_6:
        case Qt::Key_Right:
            return Way::Right;
        case Qt::Key_8:
        case Qt::Key_Up:
            return Way::Up;
        case Qt::Key_2:
        case Qt::Key_Down:
            return Way::Down;
        case Qt::Key_5:
        case Qt::Key_Clear:
            return Way::Centre;
        default:
            return std::nullopt;
    }
}

bool CameraKeys::isOurs(const QKeyEvent& event) const {
    if (!wayOf(event)) return false;
    const auto others = event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    return !others || (others == Qt::ControlModifier && m_driving());
}

bool CameraKeys::take(const QKeyEvent& event, bool held) {
    const Way way = *wayOf(event);
    if (event.isAutoRepeat()) return true;
    m_slow = event.modifiers().testFlag(Qt::ShiftModifier);
    if (way == Way::Centre) {
        if (held) emit recentreWanted();
        return true;
    }
    if (held) {
        m_held.insert(way);
    } else {
        m_held.erase(way);
    }
    publish();
    return true;
}

void CameraKeys::letGo() {
    if (m_held.empty()) return;
    m_held.clear();
    publish();
}

void CameraKeys::publish() {
    const auto share = [this](Way plus, Way minus) {
        return static_cast<double>(m_held.count(plus)) - static_cast<double>(m_held.count(minus));
    };
    const double speed = m_slow ? Slow : Fast;
    emit rateWanted({speed * share(Way::Left, Way::Right), speed * share(Way::Down, Way::Up)});
}

bool CameraKeys::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
        case QEvent::KeyRelease: {
            const auto* widget = qobject_cast<QWidget*>(watched);
            if (widget == nullptr) return false;
            auto& key = static_cast<QKeyEvent&>(*event);
            // A key that went down here counts as released even when a modifier or a menu came meanwhile.
            // Other keys belong to driving.
            if (event->type() == QEvent::KeyRelease) {
                const auto way = wayOf(key);
                return way && m_held.contains(*way) && take(key, false);
            }
            if (widget->window() != &m_window) return false;
            if (!isOurs(key) || isWrittenInto(*widget)) return false;
            if (event->type() == QEvent::KeyPress) return take(key, true);
            event->accept();
            return true;
        }
        case QEvent::WindowDeactivate:
            if (watched == &m_window) letGo();
            return false;
        default:
            return false;
    }
}

}  // namespace leitstand
