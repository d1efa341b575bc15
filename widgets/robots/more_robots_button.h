#pragma once

#include <QAbstractButton>

#include "widgets/models/live/robots/robot_row.h"

namespace leitstand {

/// Scrolls the bar of robots to one side and tells of those that are hidden there: how many, the worst of
/// their links, and the stop that is to be looked at first.
class MoreRobotsButton final : public QAbstractButton {
    Q_OBJECT
public:
    enum class End { Before, After };
    static constexpr int Width = 40;  ///< [px]

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
