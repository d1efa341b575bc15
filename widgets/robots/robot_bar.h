#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/live/robots/robot_chip.h"
#include "widgets/models/live/texts/stop_line.h"

class QButtonGroup;

namespace leitstand {

class MoreRobotsButton;
class RobotChipButton;

/// The bar of all robots at the top. Each robot is a button of the same width: letter, link, battery, mode,
/// and stage of a stop. The selected robot is framed. A click or a number key selects a robot. If a robot is
/// stopped, holding the lower half of its button releases it. With little space, buttons shrink to letters,
/// then the bar scrolls. The selected robot is always visible, and buttons at the ends show what is hidden.
/// Changes of robots' states move no button.
class RobotBar final : public QWidget {
    Q_OBJECT
public:
    explicit RobotBar(QWidget* parent = nullptr);

    /// Shows one chip and one stop per robot, always in the same order. Without @p stops, no robot is
    /// stopped. @p selected: RobotFace::name.
    void show(const std::vector<RobotChip>& chips, const std::vector<StopLine>& stops,
              const QString& selected);
    using QWidget::show;

    /// sizeHint() is wide enough for all important details of all robots, at least 160 px each.
    /// minimumSizeHint() is wide enough for a few robots shown only as letters.
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void robotSelected(const QString& robot);     ///< RobotFace::name; chosen by the operator
    void releaseRequested(const QString& robot);  ///< RobotFace::name; the handle was held for a second

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
    [[nodiscard]] int capacity() const;  ///< number of robots that fit

    QButtonGroup* m_group;
    MoreRobotsButton *m_before, *m_after;
    std::vector<RobotChipButton*> m_buttons;
    std::vector<RobotChip> m_chips;  ///< chips that are shown
    std::vector<StopLine> m_stops;
    int m_selected = -1;  ///< place of the selected robot; -1: none
    int m_first = 0;      ///< first robot of the scrolled row
    int m_turned = 0;     ///< wheel rotation that is less than a whole step [1/8 degree]
};

}  // namespace leitstand
