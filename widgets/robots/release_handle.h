#pragma once

#include <QBasicTimer>
#include <QWidget>

#include "widgets/models/live/hold_to_act.h"
#include "widgets/models/live/texts/stop_line.h"

namespace leitstand {

/// Shows the stage of one robot's stop. Requests the release when it is held for a second with the pointer,
/// Space or Return. Releasing it, losing the focus or moving the pointer away cancels this. While nothing can
/// be released, clicks go to the widget below.
class ReleaseHandle final : public QWidget {
    Q_OBJECT
public:
    explicit ReleaseHandle(QWidget* parent = nullptr);

    void show(const StopLine& line);
    using QWidget::show;
    [[nodiscard]] bool isHeld() const { return m_hold.isHeld(); }
    /// Returns the width needed for the shortest text of every state, in @p font and the window's language
    /// [px].
    [[nodiscard]] static int foldedWidth(const QFont& font);

signals:
    void held(const QString& robot);  ///< the operator held the handle for a full second

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
    [[nodiscard]] QStringList texts() const;  ///< the texts it can show, longest first

    StopLine m_line;
    HoldToAct m_hold;
    QBasicTimer m_timer;
};

}  // namespace leitstand
