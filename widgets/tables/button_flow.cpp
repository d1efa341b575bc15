#include "widgets/tables/button_flow.h"

#include <algorithm>

namespace leitstand {

ButtonFlow::ButtonFlow() = default;

ButtonFlow::~ButtonFlow() {
    for (QLayoutItem* item : m_items) delete item;
}

void ButtonFlow::addItem(QLayoutItem* item) {
    m_items.push_back(item);
}

QLayoutItem* ButtonFlow::itemAt(int index) const {
    return index < 0 || index >= count() ? nullptr : m_items[static_cast<std::size_t>(index)];
}

QLayoutItem* ButtonFlow::takeAt(int index) {
    QLayoutItem* const item = itemAt(index);
    if (item != nullptr) m_items.erase(m_items.begin() + index);
    return item;
}

int ButtonFlow::heightForWidth(int width) const {
    return lay({0, 0, width, 0}, false);
}

QSize ButtonFlow::minimumSize() const {
    QSize most;
    for (const QLayoutItem* item : m_items) most = most.expandedTo(item->sizeHint());
    const QMargins margins = contentsMargins();
    return most + QSize(margins.left() + margins.right(), margins.top() + margins.bottom());
}

void ButtonFlow::setGeometry(const QRect& area) {
    QLayout::setGeometry(area);
    lay(area, true);
}

int ButtonFlow::lay(const QRect& area, bool place) const {
    const QRect inner = area.marginsRemoved(contentsMargins());
    const int gap = std::max(0, spacing());
    int x = inner.left(), y = inner.top(), line = 0;
    for (QLayoutItem* item : m_items) {
        if (item->isEmpty()) continue;
        const QSize size = item->sizeHint();
        if (x > inner.left() && x + size.width() > inner.right() + 1) {
            x = inner.left();
            y += line + gap;
            line = 0;
        }
        if (place) item->setGeometry({QPoint(x, y), size});
        x += size.width() + gap;
        line = std::max(line, size.height());
    }
    return y + line - inner.top() + contentsMargins().top() + contentsMargins().bottom();
}

}  // namespace leitstand
