#pragma once

#include <functional>
#include <set>

#include <QObject>
#include <QString>

#include "core/robot/control/pan_tilt.h"

class QKeyEvent;
class QWidget;

namespace leitstand {

/// Requests turns of the cameras while keys that do not drive are held: Q and E pan, Page Up and Page Down
/// tilt. On the number pad, 4 6 8 2 turn and 5 re-centres. With Shift, cameras turn slowly. In text fields
/// these keys only type.
class CameraKeys final : public QObject {
    Q_OBJECT
public:
    /// Observes the keys of @p window and of the widgets in it. @p driving returns whether the operator
    /// drives a robot. If so, Ctrl may be held with these keys, since it drives fast. Otherwise they do
    /// nothing with Ctrl.
    CameraKeys(QWidget& window, std::function<bool()> driving);

    /// Returns the keys as a short text for the pane: "Q E PgUp PgDn".
    [[nodiscard]] static QString names();
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The rate that the held keys request [rad/s], emitted at every change.
    void rateWanted(const leitstand::PanTiltAngles& perSecond);
    void recentreWanted();

private:
    enum class Way { Left, Right, Up, Down, Centre };
    [[nodiscard]] static std::optional<Way> wayOf(const QKeyEvent& event);
    [[nodiscard]] bool isOurs(const QKeyEvent& event) const;
    bool take(const QKeyEvent& event, bool held);
    void letGo();
    void publish();

    QWidget& m_window;
    std::function<bool()> m_driving;
    std::set<Way> m_held;
    bool m_slow = false;
};

}  // namespace leitstand
