#include "widgets/frames/frames_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableView>
#include <QVBoxLayout>

#include "widgets/painting/pane_paint.h"
#include "widgets/painting/theme.h"
#include "widgets/tables/column_fitter.h"
#include "widgets/tables/table_dress.h"

namespace leitstand {

FramesPanel::FramesPanel(QWidget* parent)
    : QWidget(parent), m_summary(new QLabel(this)), m_table(new QTableView(this)) {
    setAccessibleName(tr("Frames"));
    m_summary->setObjectName(QStringLiteral("framesSummary"));
    m_summary->setWordWrap(true);
    m_summary->setMargin(6);
    m_table->setObjectName(QStringLiteral("frames"));
    m_table->setAccessibleName(tr("Frames of the robot, each below its parent"));
    m_table->setModel(&m_rows);
    dressTable(*m_table);
    m_table->setFrameShape(QFrame::NoFrame);
    new ColumnFitter(*m_table, {FrameRowsModel::Place, FrameRowsModel::Rate}, FrameRowsModel::Frame);
    auto* const rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_summary);
    rows->addWidget(m_table, 1);
}

void FramesPanel::showFrames(const std::vector<FrameLine>& lines, const QString& summary, bool attention) {
    m_rows.show(lines);
    if (m_summary->text() != summary) m_summary->setText(summary);
    const ThemeColours& colours = coloursOf(presentTheme());
    const QColor& ink = toneColour(attention ? Tone::Attention : Tone::Normal, colours);
    QPalette palette = m_summary->palette();
    if (palette.color(QPalette::WindowText) == ink) return;
    palette.setColor(QPalette::WindowText, ink);
    m_summary->setPalette(palette);
}

}  // namespace leitstand
