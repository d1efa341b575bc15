#include "widgets/joints/joints_panel.h"

#include <algorithm>

#include <QAction>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/joints/joint_drawing.h"
#include "widgets/models/joints/joint_lines.h"
#include "widgets/models/others_text.h"
#include "widgets/tables/button_flow.h"
#include "widgets/tables/chosen_row.h"
#include "widgets/tables/command_buttons.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {
namespace {

constexpr int RowHeight = 22;      // [px]
constexpr int LeastDrawing = 110;  // [px]

}  // namespace

JointsPanel::JointsPanel(QWidget* parent)
    : QWidget(parent),
      m_drawing(new JointDrawing(this)),
      m_table(new QTableView(this)),
      m_none(new QLabel(this)),
      m_buttons(new QWidget(this)) {
    setAccessibleName(tr("Flippers and arm"));
    m_table->setObjectName(QStringLiteral("joints"));
    m_table->setAccessibleName(tr("What the controls of joints move"));
    m_table->setModel(&m_model);
    dressTable(*m_table, RowHeight);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->horizontalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(JointRowsModel::Title, QHeaderView::Stretch);
    m_table->setTextElideMode(Qt::ElideRight);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& row) {
                const auto at = static_cast<std::size_t>(row.row());
                if (row.isValid() && at < m_model.rows().size()) emit axisChosen(m_model.rows()[at].id);
            });
    m_none->setProperty("muted", true);
    m_none->setAlignment(Qt::AlignCenter);
    m_none->setWordWrap(true);
    m_buttons->setLayout(new ButtonFlow);
    m_buttons->layout()->setContentsMargins(8, 2, 8, 6);
    m_buttons->layout()->setSpacing(2);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_drawing, 1);
    rows->addWidget(m_table);
    rows->addWidget(m_buttons);
    rows->addWidget(m_none, 1);
    show(nullptr, {}, {});
}

void JointsPanel::setCommands(const std::vector<QAction*>& commands) {
    addCommandButtons(*m_buttons->layout(), commands, *this);
    for (QAction* const command : commands) {
        auto* const button = findChild<QToolButton*>(command->objectName());
        if (button == nullptr) continue;
        const auto follow = [this, command, button] {
            button->setVisible(command->isVisible());
            fit();
        };
        connect(command, &QAction::changed, this, follow);
        follow();
    }
}

void JointsPanel::show(const RobotDescription* robot, const JointGroupViews& now, const JointAxisId& chosen) {
    m_any = robot != nullptr && !robot->jointGroups.empty();
    if (!m_any) {
        m_none->setText(
            robot == nullptr
                ? QString()
                : tr("The file of %1 names no flippers and no arm").arg(othersText(robot->title)));
        m_model.show({});
        fit();
        return;
    }
    const std::vector<JointRow> rows = jointRows(*robot, now);
    const auto at =
        std::find_if(rows.begin(), rows.end(), [&](const JointRow& row) { return row.id == chosen; });
    {
        const QSignalBlocker quiet(m_table->selectionModel());
        m_model.show(rows);
    }
    // The header is hidden: its word needs no room.
    m_table->horizontalHeader()->resizeSection(
        JointRowsModel::Position,
        static_cast<QAbstractItemView*>(m_table)->sizeHintForColumn(JointRowsModel::Position));
    const int row = at == rows.end() ? -1 : static_cast<int>(at - rows.begin());
    if (m_table->currentIndex().row() != row) chooseRow(*m_table, row);
    std::vector<JointLine> lines;
    QString status;
    Tone tone = Tone::Normal;
    for (const JointGroup& group : robot->jointGroups) {
        const auto view = now.find(group.name);
        if (view == now.end()) continue;
        const auto axis = chosen.group == group.name ? std::optional(chosen.axis) : std::nullopt;
        for (const JointLine& line : jointLines(group, view->second.positions, axis)) lines.push_back(line);
        // The group that the controls move counts, unless something is odd with another one.
        const Tone its = jointTone(view->second);
        if (its > tone || (axis && its == tone)) {
            status = jointStatus(group, view->second);
            tone = its;
        }
    }
    m_drawing->show(bodyFromTheSide(*robot), reachFromTheSide(*robot, lines), lines);
    m_drawing->setStatus(status, tone);
    fit();
}

void JointsPanel::fit() {
    const int rows = static_cast<int>(m_model.rows().size()) * RowHeight + 2;
    const int buttons = m_buttons->layout()->isEmpty() ? 0 : m_buttons->layout()->heightForWidth(width());
    const bool table = m_any && height() >= LeastDrawing + rows;
    m_table->setFixedHeight(rows);
    m_table->setVisible(table);
    m_buttons->setVisible(table && buttons > 0 && height() >= LeastDrawing + rows + buttons);
    m_drawing->setVisible(m_any);
    m_none->setVisible(!m_any);
}

void JointsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

}  // namespace leitstand
