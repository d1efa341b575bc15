#include "widgets/map_decisions/map_question.h"

#include <algorithm>

#include <QAction>
#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QMargins>
#include <QToolButton>

namespace leitstand {
namespace {

qsizetype countOver(const QWidget& over) {
    return over.findChildren<MapQuestion*>(QString(), Qt::FindDirectChildrenOnly).size();
}

}  // namespace

MapQuestion::MapQuestion(const QString& name, const std::vector<QAction*>& answers, QWidget& over)
    : QFrame(&over),
      m_number(static_cast<int>(countOver(over))),
      m_text(new QLabel(this)),
      m_parts(new QBoxLayout(QBoxLayout::TopToBottom, this)) {
    setObjectName(name);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_parts->addWidget(m_text, 1);
    auto* buttons = new QHBoxLayout;
    for (QAction* command : answers) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("button_") + command->objectName());
        button->setDefaultAction(command);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setFocusPolicy(Qt::NoFocus);
        buttons->addWidget(button);
    }
    m_parts->addLayout(buttons);
    over.installEventFilter(this);
    hide();
}

void MapQuestion::ask(const QString& question) {
    if (question == m_question) return;
    m_question = question;
    m_text->setToolTip(question);
    setAccessibleName(question);
    setVisible(!question.isEmpty());
    placeAll();  // those above it move up or down
}

void MapQuestion::placeAll() {
    for (MapQuestion* const one : others()) {
        if (!one->isHidden()) one->place();
    }
}

QList<MapQuestion*> MapQuestion::others() const {
    auto all = parentWidget()->findChildren<MapQuestion*>(QString(), Qt::FindDirectChildrenOnly);
    // raise() moves a widget to the end of its parent's children.
    std::sort(all.begin(), all.end(),
              [](const MapQuestion* a, const MapQuestion* b) { return a->m_number < b->m_number; });
    return all;
}

bool MapQuestion::eventFilter(QObject* watched, QEvent* event) {
    // Each is stacked on the one before: the first places all.
    if (watched == parent() && event->type() == QEvent::Resize && others().front() == this) placeAll();
    return QFrame::eventFilter(watched, event);
}

void MapQuestion::place() {
    constexpr int Widest = 420, Margin = 12, AboveLegend = 48, Small = 480, AtEdge = 4;
    const QSize room = parentWidget()->size();
    // A small map is for driving: it shows one line at its edge, without the consequences.
    const bool small = room.height() < Small;
    m_text->setText(small ? m_question.section(QLatin1Char('\n'), 0, 0) : m_question);
    m_parts->setDirection(small ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_parts->setContentsMargins(small ? QMargins(8, 2, 8, 2) : QMargins(10, 6, 10, 8));
    m_text->setAlignment(small ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignCenter);
    const int margin = small ? AtEdge : Margin;
    const int width = std::max(160, std::min(small ? room.width() : Widest, room.width() - 2 * margin));
    const int height = m_parts->heightForWidth(width);
    int below = small ? AtEdge : AboveLegend;
    for (const MapQuestion* const one : others()) {
        if (one == this) break;
        if (!one->isHidden()) below += one->height() + AtEdge;
    }
    setGeometry((room.width() - width) / 2, std::max(0, room.height() - height - below), width, height);
    raise();
}

}  // namespace leitstand
