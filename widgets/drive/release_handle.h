#pragma once

#include <QBasicTimer>
#include <QWidget>

#include "widgets/models/live/hold_to_act.h"
#include "widgets/models/live/stop_line.h"

namespace leitstand {

/// How far the stop of one robot came; held for a second, by pointer or by Space or Return, it asks to let
/// the robot go. Letting go, losing the focus and leaving it with the pointer break it off.
class ReleaseHandle final : public QWidget {
    Q_OBJECT
public:
    explicit ReleaseHandle(QWidget* parent = nullptr);

    void show(const StopLine& line);
    using QWidget::show;
    [[nodiscard]] bool isHeld() const { return m_hold.isHeld(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void held(const QString& robot);  ///< for a full second

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void timerEvent(QTimerEvent* event) override;

private:
    void begin();
    void end();
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString essential() const;  ///< of it, where there is little room: "no answer for 2.9 s"

    StopLine m_line;
    HoldToAct m_hold;
    QBasicTimer m_timer;
};

}  // namespace leitstand
