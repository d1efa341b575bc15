#include "app/window/live/window_frame.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>

#include "widgets/plain_texts.h"

namespace leitstand {
namespace {

constexpr int Recent = 8;  ///< messages that are kept: one that another one covers at once can be read

}  // namespace

WindowFrame::WindowFrame(QMainWindow& window)
    : QObject(&window), m_window(window), m_word(new QLabel(&window)) {
    m_word->setObjectName(QStringLiteral("word"));
    m_word->setAccessibleName(tr("Newest message"));
    m_word->setProperty("muted", true);
    m_word->setContentsMargins(8, 7, 12, 0);
    m_word->setTextFormat(Qt::PlainText);  // robots and files are quoted in it
    window.menuBar()->setCornerWidget(m_word);
}

void WindowFrame::build(const std::vector<QWidget*>& left, const std::vector<QWidget*>& right, QWidget& panes,
                        QWidget* below) {
    auto* top = new QWidget(&m_window);
    top->setAttribute(Qt::WA_StyledBackground);
    auto* bar = new QHBoxLayout(top);
    bar->setContentsMargins(8, 6, 8, 6);
    bar->setSpacing(12);
    for (QWidget* one : left) bar->addWidget(one);
    bar->addStretch(1);
    for (QWidget* one : right) bar->addWidget(one);
    auto* whole = new QWidget(&m_window);
    auto* rows = new QVBoxLayout(whole);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(top);
    rows->addWidget(&panes, 1);
    if (below != nullptr) rows->addWidget(below);
    m_window.setCentralWidget(whole);
    for (QMenu* menu : m_window.menuBar()->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly))
        menu->menuAction()->setVisible(!menu->isEmpty());
}

void WindowFrame::tell(const QString& text) {
    // The menus need the other half.
    m_word->setText(m_word->fontMetrics().elidedText(text, Qt::ElideRight, m_window.width() / 2));
    m_recent.prepend(text);
    if (m_recent.size() > Recent) m_recent.removeLast();
    m_word->setToolTip(inLines(m_recent.join(QLatin1Char('\n'))));
    m_window.menuBar()->setCornerWidget(m_word);  // lays it out anew
    m_word->show();
}

QString WindowFrame::newest() const {
    return m_recent.value(0);
}

}  // namespace leitstand
