#include "widgets/scans/scan_details_view.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/models/scan_texts.h"

namespace leitstand {
namespace {

QLabel* lineLabel(QGridLayout& lines, int row, int column) {
    if (auto* item = lines.itemAtPosition(row, column)) return qobject_cast<QLabel*>(item->widget());
    auto* label = new QLabel(lines.parentWidget());
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    label->setProperty("muted", column == 0);
    label->setWordWrap(column == 1);
    if (column == 1) label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    lines.addWidget(label, row, column);
    return label;
}

}  // namespace

ScanDetailsView::ScanDetailsView(QWidget* parent) : QWidget(parent), m_lines(new QGridLayout(this)) {
    setObjectName(QStringLiteral("scanDetails"));
    m_lines->setContentsMargins(10, 8, 10, 10);
    m_lines->setHorizontalSpacing(12);
    m_lines->setVerticalSpacing(4);
    m_lines->setColumnStretch(1, 1);
    setVisible(false);
}

void ScanDetailsView::setScan(const MapScan* scan) {
    const std::vector<ScanDetail> details = scan != nullptr ? scanDetails(*scan) : std::vector<ScanDetail>{};
    const int used = static_cast<int>(details.size());
    for (int row = 0; row < used; ++row) {
        const auto& [caption, value] = details[static_cast<std::size_t>(row)];
        lineLabel(*m_lines, row, 0)->setText(caption);
        lineLabel(*m_lines, row, 1)->setText(value);
    }
    for (int row = 0; row < m_lines->rowCount(); ++row) {
        for (int column = 0; column < 2 && m_lines->itemAtPosition(row, column) != nullptr; ++column) {
            m_lines->itemAtPosition(row, column)->widget()->setVisible(row < used);
        }
    }
    setVisible(used > 0);
}

}  // namespace leitstand
