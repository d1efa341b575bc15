#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/joints/joint_texts.h"

class QAction;
class QLabel;
class QTableView;

namespace leitstand {

class JointDrawing;

/// A robot's flippers and arm: how they stand, which of them the controls move, and buttons for commands.
/// Where there is little room, the buttons give way first, then the table.
class JointsPanel final : public QWidget {
    Q_OBJECT
public:
    explicit JointsPanel(QWidget* parent = nullptr);

    /// Shows @p robot, whose groups are as @p now says; null, or one without joints: says so. @p chosen: the
    /// axis that the controls move.
    void show(const RobotDescription* robot, const JointGroupViews& now, const JointAxisId& chosen);
    using QWidget::show;
    /// Adds a button for each of @p commands.
    void setCommands(const std::vector<QAction*>& commands);

    [[nodiscard]] QSize sizeHint() const override { return {260, 260}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 80}; }

signals:
    void axisChosen(const leitstand::JointAxisId& axis);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    JointRowsModel m_model;
    JointDrawing* m_drawing;
    QTableView* m_table;
    QLabel* m_none;
    QWidget* m_buttons;
    bool m_any = false;
};

}  // namespace leitstand
