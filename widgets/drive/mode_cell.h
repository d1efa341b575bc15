#pragma once

#include <QWidget>

#include "widgets/models/live/robots/drive_state.h"

class QToolButton;

namespace leitstand {

/// Shows the mode of the selected robot in the largest text of the window, on the background of that mode.
/// Below it are a hint, the holder of the grant to drive, speeds of chains, speed, turn rate and the nearest
/// obstacle.
class ModeCell final : public QWidget {
    Q_OBJECT
public:
    explicit ModeCell(QWidget* parent = nullptr);

    void show(const DriveState& state);
    using QWidget::show;
    [[nodiscard]] QSize sizeHint() const override { return {272, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {234, 150}; }

signals:
    void grantAsked();
    void grantGivenUp();
    void grantAnswered(bool consent);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void placeButtons();
    [[nodiscard]] QRectF grantLine() const;

    DriveState m_state;
    QToolButton *m_first, *m_second;  ///< first button: ask, give up or consent; second button: refuse
};

}  // namespace leitstand
