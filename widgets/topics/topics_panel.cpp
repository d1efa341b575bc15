#include "widgets/topics/topics_panel.h"

#include <algorithm>

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/tables/chosen_row.h"
#include "widgets/tables/table_dress.h"
#include "widgets/topics/trend_plot.h"

namespace leitstand {
namespace {

constexpr int RowHeight = 21;                                       // [px]
constexpr int LeastForPlot = 240;                                   // [px]
constexpr int TopicWidth = 180, TypeWidth = 190, NodesWidth = 150;  // [px]

QTableView* table(QWidget* parent, QAbstractItemModel& model, const char* name) {
    auto* const made = new QTableView(parent);
    made->setObjectName(QLatin1String(name));
    made->setModel(&model);
    dressTable(*made, RowHeight);
    made->setFrameShape(QFrame::NoFrame);
    return made;
}

}  // namespace

TopicsPanel::TopicsPanel(QWidget* parent)
    : QWidget(parent),
      m_filter(new QLineEdit(this)),
      m_topicTable(table(this, m_topics, "topics")),
      m_fieldTable(table(this, m_fields, "fields")),
      m_summary(new QLabel(this)),
      m_plot(new TrendPlot(this)),
      m_halves(new QSplitter(Qt::Vertical, this)) {
    setAccessibleName(tr("Topics"));
    m_filter->setObjectName(QStringLiteral("topicFilter"));
    m_filter->setPlaceholderText(tr("Words of topic, type or node"));
    m_filter->setClearButtonEnabled(true);
    m_topicTable->setAccessibleName(tr("Topics of the domain"));
    m_topicTable->setTextElideMode(Qt::ElideLeft);  // ends of names tell them apart
    m_topicTable->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_topicTable->horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
    m_topicTable->horizontalHeader()->setSectionResizeMode(TopicRowsModel::Topic, QHeaderView::Stretch);
    m_topicTable->horizontalHeader()->resizeSection(TopicRowsModel::Type, TypeWidth);
    m_topicTable->horizontalHeader()->resizeSection(TopicRowsModel::Nodes, NodesWidth);
    connect(m_halves, &QSplitter::splitterMoved, this, &TopicsPanel::fit);
    m_fieldTable->setAccessibleName(tr("The newest message of the chosen topic"));
    m_fieldTable->horizontalHeader()->hide();
    m_fieldTable->horizontalHeader()->setSectionResizeMode(FieldRowsModel::Value, QHeaderView::Stretch);
    m_fieldTable->horizontalHeader()->resizeSection(FieldRowsModel::Field, 130);
    m_summary->setObjectName(QStringLiteral("topicSummary"));
    m_summary->setWordWrap(true);
    m_summary->setContentsMargins(8, 4, 8, 4);
    connect(m_filter, &QLineEdit::textChanged, this, &TopicsPanel::fill);
    connect(m_topicTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& row) {
                const auto at = static_cast<std::size_t>(row.row());
                if (!row.isValid() || at >= m_topics.rows().size()) return;
                if (m_topics.rows()[at].topic == m_chosen) return;
                m_chosen = m_topics.rows()[at].topic;
                m_plotted.clear();
                showMessage({}, {});
                showPlot({}, 1.0);
                emit topicChosen(m_chosen);
            });
    connect(m_fieldTable, &QTableView::clicked, this, [this](const QModelIndex& row) {
        const auto at = static_cast<std::size_t>(row.row());
        if (at >= m_fields.rows().size() || !m_fields.rows()[at].number) return;
        m_plotted = m_fields.rows()[at].path;
        emit fieldChosen(m_plotted);
    });
    auto* below = new QWidget(this);
    auto* details = new QVBoxLayout(below);
    details->setContentsMargins(0, 0, 0, 0);
    details->setSpacing(0);
    details->addWidget(m_summary);
    details->addWidget(m_fieldTable, 1);
    details->addWidget(m_plot);
    m_halves->addWidget(m_topicTable);
    m_halves->addWidget(below);
    m_halves->setStretchFactor(0, 2);
    m_halves->setStretchFactor(1, 3);
    m_halves->setChildrenCollapsible(false);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_filter);
    rows->addWidget(m_halves, 1);
    m_plot->setVisible(false);
    showMessage({}, {});
}

void TopicsPanel::showTopics(const std::vector<TopicRow>& rows) {
    m_rows = rows;
    fill();
}

void TopicsPanel::fill() {
    const std::vector<TopicRow> rows = filtered(m_rows, m_filter->text());
    m_topics.show(rows);
    const auto at =
        std::find_if(rows.begin(), rows.end(), [this](const TopicRow& row) { return row.topic == m_chosen; });
    const int row = at == rows.end() ? -1 : static_cast<int>(at - rows.begin());
    if (m_topicTable->currentIndex().row() != row) chooseRow(*m_topicTable, row);
}

void TopicsPanel::showMessage(const QString& summary, const std::vector<FieldRow>& fields) {
    m_summary->setText(m_chosen.isEmpty()
                           ? tr("Choose a topic: what comes on it is shown here, and only then "
                                "loads the link")
                           : summary);
    m_fields.show(fields);
}

void TopicsPanel::showPlot(const std::vector<std::pair<double, double>>& points, double span) {
    fit();
    m_plot->show(m_plotted, points, span);
}

void TopicsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    emit shownChanged(true);
}

void TopicsPanel::fit() {
    m_halves->setOrientation(width() > height() ? Qt::Horizontal : Qt::Vertical);
    m_plot->setVisible(!m_plotted.isEmpty() && height() >= LeastForPlot);
    const bool beside = m_halves->orientation() == Qt::Horizontal;
    const int room = (beside ? m_halves->sizes().value(0) : width()) - TopicWidth;
    m_topicTable->setColumnHidden(TopicRowsModel::Type, room < TypeWidth);
    m_topicTable->setColumnHidden(TopicRowsModel::Nodes, room < TypeWidth + NodesWidth);
}

void TopicsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void TopicsPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit shownChanged(false);
}

}  // namespace leitstand
