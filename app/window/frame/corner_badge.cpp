#include "app/window/frame/corner_badge.h"

#include <QLabel>

namespace leitstand {

QLabel* makeCornerBadge(QWidget& parent, const QString& name) {
    auto* badge = new QLabel(&parent);
    badge->setObjectName(name);
    badge->setProperty("badge", true);
    badge->setTextFormat(Qt::PlainText);  // contains names of robots
    badge->hide();
    return badge;
}

}  // namespace leitstand
