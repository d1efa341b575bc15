#pragma once

#include <functional>

#include <QObject>
#include <QString>

#include "app/window/input/held_keys.h"
#include "core/robot/control/pan_tilt.h"

class QWidget;

namespace leitstand {

/// Requests turns of the cameras while keys that do not drive are held: Q and E pan, Page Up and Page Down
/// tilt. On the number pad, 4 6 8 2 turn and 5 re-centres. With Shift, cameras turn slowly. In text fields
/// these keys only type.
class CameraKeys final : public QObject {
    Q_OBJECT
public:
    /// As HeldKeys.
    CameraKeys(QWidget& window, std::function<bool()> driving);

    /// Returns the keys as a short text for the pane: "Q E PgUp PgDn".
    [[nodiscard]] static QString names();

signals:
    /// The rate that the held keys request [rad/s], emitted at every change.
    void rateWanted(const leitstand::PanTiltAngles& perSecond);
    void recentreWanted();

private:
    void publish();

    HeldKeys m_keys;
    PanTiltAngles m_rate;  ///< emitted last
};

}  // namespace leitstand
