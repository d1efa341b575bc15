#pragma once

#include <QBasicTimer>
#include <QWidget>

#include "widgets/models/live/hold_to_act.h"
#include "widgets/models/live/texts/stop_line.h"

namespace leitstand {

/// How far the stop of one robot came; held for a second, by pointer or by Space or Return, it asks to let
/// the robot go. Letting go, losing the focus and leaving it with the pointer break it off. While nothing can
/// be released, clicks go to what is below it.
class ReleaseHandle final : public QWidget {
    Q_OBJECT
public:
    explicit ReleaseHandle(QWidget* parent = nullptr);

    void show(const StopLine& line);
    using QWidget::show;
    [[nodiscard]] bool isHeld() const { return m_hold.isHeld(); }
    /// In @p font: the width at which the shortest words of each state are whole, in the window's language.
    [[nodiscard]] static int foldedWidth(const QFont& font);

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
    [[nodiscard]] QStringList texts() const;  ///< what it may show, the longest first

    StopLine m_line;
    HoldToAct m_hold;
    QBasicTimer m_timer;
};

}  // namespace leitstand
