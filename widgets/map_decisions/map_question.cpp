#include "widgets/map_decisions/map_question.h"

#include <algorithm>

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace leitstand {

MapQuestion::MapQuestion(const QString& name, QAction& yes, QAction& no, QWidget& over)
    : QFrame(&over), m_text(new QLabel(this)) {
    setObjectName(name);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignCenter);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(10, 6, 10, 8);
    rows->addWidget(m_text);
    auto* buttons = new QHBoxLayout;
    for (QAction* command : {&yes, &no}) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("button_") + command->objectName());
        button->setDefaultAction(command);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setFocusPolicy(Qt::NoFocus);
        buttons->addWidget(button);
    }
    rows->addLayout(buttons);
    over.installEventFilter(this);
    hide();
}

void MapQuestion::ask(const QString& question) {
    m_text->setText(question);
    setAccessibleName(question);
    setVisible(!question.isEmpty());
    if (!question.isEmpty()) place();
}

bool MapQuestion::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parent() && event->type() == QEvent::Resize && !isHidden()) place();
    return QFrame::eventFilter(watched, event);
}

void MapQuestion::place() {
    constexpr int Widest = 420, Margin = 12, AboveLegend = 48;
    const QSize room = parentWidget()->size();
    const int width = std::max(160, std::min(Widest, room.width() - 2 * Margin));
    const int height = layout()->heightForWidth(width);
    setGeometry((room.width() - width) / 2, room.height() - height - AboveLegend, width, height);
    raise();
}

}  // namespace leitstand
