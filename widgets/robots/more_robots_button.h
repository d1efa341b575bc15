#pragma once

#include <QAbstractButton>

#include "widgets/models/live/robots/robot_row.h"

namespace leitstand {

/// Scrolls the robot bar to one side and shows what is hidden there: the number of robots, their worst link,
/// and their most urgent stop.
class MoreRobotsButton final : public QAbstractButton {
    Q_OBJECT
public:
    enum class End { Before, After };
    static constexpr int Width = 40;  ///< width [px]

    explicit MoreRobotsButton(End end, QWidget* parent = nullptr);

    void show(const HiddenRobots& hidden);
    using QWidget::show;
    [[nodiscard]] const HiddenRobots& hidden() const { return m_hidden; }
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const End m_end;
    HiddenRobots m_hidden;
};

}  // namespace leitstand
