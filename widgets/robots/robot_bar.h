#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/stop_line.h"

class QButtonGroup;

namespace leitstand {

class MoreRobotsButton;
class RobotChipButton;

/// All robots in the bar on top, each a button of the same width: letter, link, battery and mode, and how far
/// its stop is; the selected one is framed. A click or its number key selects, its lower half releases it
/// when it is held. Where there is little room buttons fold to letters, then they scroll: the selected one
/// stays in sight, and the buttons at the ends tell what is hidden. What robots do moves nothing.
class RobotBar final : public QWidget {
    Q_OBJECT
public:
    explicit RobotBar(QWidget* parent = nullptr);

    /// One chip and one stop per robot, always in the same order; without @p stops none is stopped. @p
    /// selected: RobotFace::name.
    void show(const std::vector<RobotChip>& chips, const std::vector<StopLine>& stops,
              const QString& selected);
    using QWidget::show;

    /// How wide it is where robots show all that matters, and where they are folded; at least 160 px a robot
    /// and a few of them.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void robotSelected(const QString& robot);     ///< its name, as the operator chose
    void releaseRequested(const QString& robot);  ///< its name; was held for a second

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void addButton();
    void reveal(int place);  ///< scrolls to a robot
    void scroll(int robots);
    void place();
    [[nodiscard]] int folded() const;
    [[nodiscard]] int capacity() const;  ///< how many robots have room

    QButtonGroup* m_group;
    MoreRobotsButton *m_before, *m_after;
    std::vector<RobotChipButton*> m_buttons;
    std::vector<RobotChip> m_chips;  ///< as shown
    std::vector<StopLine> m_stops;
    int m_selected = -1;  ///< place of the selected one; -1: none is
    int m_first = 0;      ///< where the row begins that is scrolled
    int m_turned = 0;     ///< by the wheel, not a whole step yet [1/8 degree]
};

}  // namespace leitstand
