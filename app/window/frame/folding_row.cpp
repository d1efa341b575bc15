#include "app/window/frame/folding_row.h"

#include <algorithm>
#include <utility>

#include <QWidget>

namespace leitstand {

std::vector<int> foldedWidths(const std::vector<PartWidths>& parts, int room) {
    std::vector<int> widths;
    int spare = room;
    for (const PartWidths& part : parts) {
        widths.push_back(part.liked);
        spare -= part.liked;
    }
    for (std::size_t i = 0; i < parts.size() && spare < 0; ++i) {
        if (parts[i].gives != GivesWay::AtOnce) continue;
        spare += widths[i] - parts[i].least;
        widths[i] = parts[i].least;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].gives != GivesWay::LittleByLittle) continue;
        const int width = std::max(parts[i].least, std::min(parts[i].most, widths[i] + spare));
        spare -= width - widths[i];
        widths[i] = width;
    }
    return widths;
}

FoldingRow::FoldingRow(QWidget* parent) : QLayout(parent) {}

FoldingRow::~FoldingRow() = default;

void FoldingRow::add(QWidget& widget, GivesWay gives, bool atRight) {
    addChildWidget(&widget);
    m_parts.push_back({std::make_unique<QWidgetItem>(&widget), gives, atRight});
    invalidate();
}

void FoldingRow::addItem(QLayoutItem* item) {
    m_parts.push_back({std::unique_ptr<QLayoutItem>(item), GivesWay::Never, false});
}

int FoldingRow::count() const {
    return static_cast<int>(m_parts.size());
}

QLayoutItem* FoldingRow::itemAt(int index) const {
    return index < 0 || index >= count() ? nullptr : m_parts[static_cast<std::size_t>(index)].item.get();
}

QLayoutItem* FoldingRow::takeAt(int index) {
    if (index < 0 || index >= count()) return nullptr;
    const auto part = m_parts.begin() + index;
    QLayoutItem* const item = part->item.release();
    m_parts.erase(part);
    return item;
}

template <class SizeOf>
QSize FoldingRow::whole(SizeOf sizeOf) const {
    const QMargins margins = contentsMargins();
    QSize size(std::max(0, count() - 1) * spacing(), 0);
    for (const Part& part : m_parts) {
        const QSize one = sizeOf(*part.item);
        size = {size.width() + one.width(), std::max(size.height(), one.height())};
    }
    return size.grownBy(margins);
}

QSize FoldingRow::sizeHint() const {
    return whole([](const QLayoutItem& item) { return item.sizeHint(); });
}

QSize FoldingRow::minimumSize() const {
    return whole([](const QLayoutItem& item) { return item.minimumSize(); });
}

void FoldingRow::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    const QRect inner = rect.marginsRemoved(contentsMargins());
    std::vector<PartWidths> parts;
    for (const Part& part : m_parts)
        parts.push_back({part.item->minimumSize().width(), part.item->sizeHint().width(),
                         part.item->maximumSize().width(), part.gives});
    const int spaces = std::max(0, count() - 1) * spacing();
    const std::vector<int> widths = foldedWidths(parts, inner.width() - spaces);
    const auto put = [&](std::size_t i, int x) {
        const int height = std::min(inner.height(), m_parts[i].item->sizeHint().height());
        m_parts[i].item->setGeometry({x, inner.top() + (inner.height() - height) / 2, widths[i], height});
    };
    int left = inner.left(), right = inner.right() + 1;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        if (m_parts[i].atRight) continue;
        put(i, left);
        left += widths[i] + spacing();
    }
    for (std::size_t i = m_parts.size(); i-- > 0;) {
        if (!m_parts[i].atRight) continue;
        right -= widths[i];
        put(i, right);
        right -= spacing();
    }
}

}  // namespace leitstand
