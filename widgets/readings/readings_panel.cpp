#include "widgets/readings/readings_panel.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/tables/chosen_row.h"
#include "widgets/tables/column_fitter.h"
#include "widgets/tables/table_dress.h"
#include "widgets/topics/trend_plot.h"

namespace leitstand {
namespace {

constexpr int LeastForPlot = 170;  // [px]

}  // namespace

ReadingsPanel::ReadingsPanel(QWidget* parent)
    : QWidget(parent), m_table(new QTableView(this)), m_none(new QLabel(this)), m_plot(new TrendPlot(this)) {
    setAccessibleName(tr("Readings"));
    m_table->setObjectName(QStringLiteral("readings"));
    m_table->setAccessibleName(tr("Readings of the robot's sensors"));
    m_table->setModel(&m_rows);
    dressTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    new ColumnFitter(*m_table, {ReadingRowsModel::Limits, ReadingRowsModel::Age}, ReadingRowsModel::Title);
    m_none->setText(tr("This robot's file names no readings"));
    m_none->setAlignment(Qt::AlignCenter);
    m_none->setWordWrap(true);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this] { emit readingChosen(); });
    auto* const rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_none, 1);
    rows->addWidget(m_table, 1);
    rows->addWidget(m_plot);
    showReadings({});
}

void ReadingsPanel::showReadings(const std::vector<ReadingRow>& rows) {
    m_rows.show(rows);
    if (!rows.empty() && !m_table->currentIndex().isValid()) chooseRow(*m_table, 0);
    m_none->setVisible(rows.empty());
    m_table->setVisible(!rows.empty());
    m_plot->setVisible(!rows.empty() && height() >= LeastForPlot);
}

std::optional<ReadingRow> ReadingsPanel::chosen() const {
    const auto row = static_cast<std::size_t>(m_table->currentIndex().row());
    if (!m_table->currentIndex().isValid() || row >= m_rows.rows().size()) return std::nullopt;
    return m_rows.rows()[row];
}

void ReadingsPanel::showPlot(const std::vector<std::pair<double, double>>& points, double span) {
    const auto row = chosen();
    m_plot->show(row ? row->title : QString(), points, span);
}

void ReadingsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_plot->setVisible(m_table->isVisibleTo(this) && height() >= LeastForPlot);
}

}  // namespace leitstand
