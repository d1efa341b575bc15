#include "app/window/live/corner_badge.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>

namespace leitstand {

QLabel* addCornerBadge(QMainWindow& window, const QString& name) {
    QMenuBar* const bar = window.menuBar();
    if (bar->cornerWidget(Qt::TopRightCorner) == nullptr) {
        auto* row = new QWidget(bar);
        auto* line = new QHBoxLayout(row);
        line->setContentsMargins(0, 0, 10, 0);
        line->setSpacing(14);
        bar->setCornerWidget(row, Qt::TopRightCorner);
    }
    QWidget* const corner = bar->cornerWidget(Qt::TopRightCorner);
    auto* badge = new QLabel(corner);
    badge->setObjectName(name);
    badge->setProperty("attention", true);
    badge->hide();
    corner->layout()->addWidget(badge);
    return badge;
}

}  // namespace leitstand
