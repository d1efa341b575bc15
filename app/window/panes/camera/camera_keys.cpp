#include "app/window/panes/camera/camera_keys.h"

#include <optional>
#include <utility>

#include <QKeyEvent>
#include <QWidget>

#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr double Fast = degrees(60), Slow = degrees(15);  ///< [rad/s]

enum Way { Left, Right, Up, Down, Centre };

std::optional<int> wayOf(const QKeyEvent& event) {
    const bool pad = event.modifiers().testFlag(Qt::KeypadModifier);
    switch (event.key()) {
        case Qt::Key_Q:
            return Left;
        case Qt::Key_E:
            return Right;
        case Qt::Key_PageUp:
            return Up;
        case Qt::Key_PageDown:
            return Down;
        default:
            break;
    }
    if (!pad) return std::nullopt;
    switch (event.key()) {
        case Qt::Key_4:
        case Qt::Key_Left:
            return Left;
        case Qt::Key_6:
        case Qt::Key_Right:
            return Right;
        case Qt::Key_8:
        case Qt::Key_Up:
            return Up;
        case Qt::Key_2:
        case Qt::Key_Down:
            return Down;
        case Qt::Key_5:
        case Qt::Key_Clear:
            return Centre;
        default:
            return std::nullopt;
    }
}

}  // namespace

CameraKeys::CameraKeys(QWidget& window, std::function<bool()> driving)
    : QObject(&window), m_keys(window, wayOf, std::move(driving)) {
    connect(&m_keys, &HeldKeys::changed, this, &CameraKeys::publish);
    connect(&m_keys, &HeldKeys::pressed, this, [this](int way) {
        if (way == Centre) emit recentreWanted();
    });
}

QString CameraKeys::names() {
    return tr("Q E PgUp PgDn");
}

void CameraKeys::publish() {
    const double speed = m_keys.withShift() ? Slow : Fast;
    const PanTiltAngles rate{speed * m_keys.share(Left, Right), speed * m_keys.share(Down, Up)};
    if (rate == m_rate) return;
    m_rate = rate;
    emit rateWanted(rate);
}

}  // namespace leitstand
