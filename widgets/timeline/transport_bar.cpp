#include "widgets/timeline/transport_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "widgets/models/timeline/timeline_text.h"
#include "widgets/models/times.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {

TransportBar::TransportBar(QWidget* parent)
    : QWidget(parent), m_buttons(new QHBoxLayout), m_time(new QLabel(this)), m_rate(new QLabel(this)) {
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 12, 0);
    row->setSpacing(12);
    m_buttons->setSpacing(2);
    row->addLayout(m_buttons);
    m_rate->setObjectName(QStringLiteral("reviewRate"));
    m_rate->setAccessibleName(tr("Speed of the review"));
    m_rate->setMinimumWidth(QFontMetrics(font()).horizontalAdvance(rateText(-0.25)) + 8);
    row->addWidget(m_rate);
    row->addStretch(1);
    m_time->setObjectName(QStringLiteral("reviewTime"));
    m_time->setAccessibleName(tr("Moment that is shown"));
    m_time->setFont(sized(font(), 15, true));
    row->addWidget(m_time);
}

void TransportBar::addCommand(QAction& action) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(&action);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);  // a click never takes the focus: the timeline keeps the keys
    button->setToolButtonStyle(action.icon().isNull() ? Qt::ToolButtonTextOnly : Qt::ToolButtonIconOnly);
    m_buttons->addWidget(button);
}

void TransportBar::addGap() {
    m_buttons->addSpacing(10);
}

void TransportBar::show(const TimelineAxis& axis, Time at, double rate) {
    m_rate->setText(rateText(rate));
    m_time->setText(tr("%1   %2 of %3")
                        .arg(wallText(at, true), recordedText(axis.recordedUntil(at)),
                             recordedText(axis.recordedUntil(axis.last()))));
}

}  // namespace leitstand
