#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/live/robot_chip.h"

class QButtonGroup;
class QHBoxLayout;

namespace leitstand {

class RobotChipButton;

/// All robots in the bar on top: letter, link, battery and mode of each, the selected one framed. A click or
/// its number key selects.
class RobotBar final : public QWidget {
    Q_OBJECT
public:
    explicit RobotBar(QWidget* parent = nullptr);

    /// One chip per robot, always in the same order. @p selected: RobotFace::name.
    void show(const std::vector<RobotChip>& chips, const QString& selected);
    using QWidget::show;

signals:
    void robotSelected(const QString& robot);  ///< its name, as the operator chose

private:
    QHBoxLayout* m_layout;
    QButtonGroup* m_group;
    std::vector<RobotChipButton*> m_chips;
};

}  // namespace leitstand
