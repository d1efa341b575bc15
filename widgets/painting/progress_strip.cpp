#include "widgets/painting/progress_strip.h"

#include <cmath>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace leitstand {

ProgressStrip::ProgressStrip(QAction& cancel, QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)) {
    setObjectName(QStringLiteral("progress"));
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_bar->setFixedWidth(160);
    auto* button = new QToolButton(this);
    button->setDefaultAction(&cancel);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setProperty("quiet", true);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    layout->addWidget(m_text);
    layout->addWidget(m_bar, 0, Qt::AlignVCenter);
    layout->addWidget(button);
    hide();
}

void ProgressStrip::show(const QString& text, double fraction) {
    m_text->setText(text);
    m_bar->setValue(static_cast<int>(std::lround(1000.0 * fraction)));
    QWidget::show();
}

}  // namespace leitstand
