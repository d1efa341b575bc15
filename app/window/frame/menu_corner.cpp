#include "app/window/frame/menu_corner.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QResizeEvent>

#include "widgets/painting/elided_label.h"

namespace leitstand {

MenuCorner::MenuCorner(QMenuBar& menus)
    : QWidget(&menus),
      m_menus(menus),
      m_taken(menus.sizeHint()),
      m_row(new QHBoxLayout(this)),
      m_message(new ElidedLabel(this)),
      m_width(std::max(0, menus.width() - m_taken.width())) {
    m_row->setContentsMargins(12, 0, 8, 0);
    m_row->setSpacing(8);
    m_row->addWidget(m_message, 1);
    m_message->setObjectName(QStringLiteral("word"));
    m_message->setAccessibleName(tr("Newest message"));
    m_message->setProperty("muted", true);
    m_message->setMostLines(2);               // an error often stands behind a file name
    m_message->setTextFormat(Qt::PlainText);  // contains names of robots and files
    menus.installEventFilter(this);
    menus.setCornerWidget(this);
}

void MenuCorner::setMessage(const QString& text, const QString& toolTip) {
    m_message->setText(text);
    m_message->setToolTip(toolTip);
}

void MenuCorner::addBadge(QLabel& badge, bool keepsPlace) {
    QSizePolicy policy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    policy.setRetainSizeWhenHidden(keepsPlace);
    badge.setSizePolicy(policy);
    m_row->addWidget(&badge);
}

QSize MenuCorner::sizeHint() const {
    return {m_width, m_taken.height()};
}

bool MenuCorner::eventFilter(QObject* watched, QEvent* event) {
    // The menu bar requests the size of its corner when it is resized.
    if (watched == &m_menus && event->type() == QEvent::Resize) {
        const QSize size = static_cast<const QResizeEvent*>(event)->size();
        m_width = std::max(0, size.width() - m_taken.width());
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace leitstand
