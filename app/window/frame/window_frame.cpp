#include "app/window/frame/window_frame.h"

#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>

#include "app/window/frame/menu_corner.h"
#include "widgets/models/others_text.h"
#include "widgets/painting/plain_texts.h"

namespace leitstand {
namespace {

constexpr int Recent = 8;  ///< messages that are kept, so that one that is replaced at once can still be read

}  // namespace

WindowFrame::WindowFrame(QMainWindow& window) : QObject(&window), m_window(window) {}

void WindowFrame::build(const std::vector<Part>& left, const std::vector<Part>& right, QWidget& panes,
                        QWidget* below) {
    auto* top = new QWidget(&m_window);
    top->setObjectName(QStringLiteral("topBar"));
    top->setAttribute(Qt::WA_StyledBackground);
    auto* bar = new FoldingRow(top);
    bar->setContentsMargins(8, 6, 8, 6);
    bar->setSpacing(10);
    for (const Part& part : left) bar->add(*part.widget, part.gives);
    for (const Part& part : right) bar->add(*part.widget, part.gives, true);
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
    m_corner = new MenuCorner(*m_window.menuBar());
    showMessage();
}

void WindowFrame::addBadge(QLabel& badge, bool keepsPlace) {
    m_corner->addBadge(badge, keepsPlace);
}

void WindowFrame::showMessage(const QString& text) {
    m_recent.prepend(othersLine(text));
    if (m_recent.size() > Recent) m_recent.removeLast();
    showMessage();
}

void WindowFrame::showMessage() {
    if (m_corner == nullptr || m_recent.isEmpty()) return;
    m_corner->setMessage(m_recent.first(), inLines(m_recent.join(QLatin1Char('\n'))));
}

QString WindowFrame::newest() const {
    return m_recent.value(0);
}

}  // namespace leitstand
