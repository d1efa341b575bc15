#include "widgets/alarms/alarm_panel.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/alarms/alarm_delegate.h"

namespace leitstand {

AlarmPanel::AlarmPanel(QWidget* parent)
    : QWidget(parent),
      m_list(new QListView(this)),
      m_head(new QHBoxLayout),
      m_title(new QLabel(this)),
      m_calm(new QLabel(tr("No alarms"), this)),
      m_acknowledge(new QToolButton(this)),
      m_mute(new QToolButton(this)) {
    setAccessibleName(tr("Alarms"));
    m_list->setObjectName(QStringLiteral("alarms"));
    m_list->setAccessibleName(tr("Alarms, newest first; Return acknowledges the chosen one"));
    m_list->setModel(&m_model);
    m_list->setItemDelegate(new AlarmDelegate(m_list));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setResizeMode(QListView::Adjust);  // rows are as high as their text
    m_calm->setProperty("muted", true);
    m_calm->setAlignment(Qt::AlignCenter);
    m_acknowledge->setObjectName(QStringLiteral("acknowledge"));
    m_acknowledge->setToolTip(tr("Acknowledges the newest alarm that is not: its tone ends"));
    m_acknowledge->setAccessibleName(tr("Acknowledge the newest alarm"));
    m_mute->setObjectName(QStringLiteral("mute"));
    m_mute->setCheckable(true);
    m_mute->setToolTip(tr("No tones for one minute; alarms are shown all the same"));
    for (QToolButton* button : {m_acknowledge, m_mute}) {
        button->setProperty("quiet", true);
        button->setFocusPolicy(Qt::TabFocus);
    }
    connect(m_list, &QListView::activated, this, [this](const QModelIndex& index) {
        if (const AlarmLine* line = m_model.line(index.row())) emit acknowledged(line->id);
    });
    connect(m_acknowledge, &QToolButton::clicked, this, &AlarmPanel::newestAcknowledged);
    connect(m_mute, &QToolButton::clicked, this, &AlarmPanel::muteToggled);

    m_head->setContentsMargins(8, 4, 0, 0);
    m_head->setSpacing(0);  // buttons have margins of their own
    m_head->addWidget(m_title, 1);
    m_head->addWidget(m_mute);
    m_head->addWidget(m_acknowledge);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addLayout(m_head);
    rows->addWidget(m_list, 1);
    rows->addWidget(m_calm, 1);
    refresh();
}

void AlarmPanel::show(const std::vector<AlarmLine>& lines, const QString& mute, const QString& brief) {
    m_model.setLines(lines);
    m_muted = mute;
    m_mutedBrief = brief.isEmpty() ? mute : brief;
    refresh();
}

void AlarmPanel::setSoundTrouble(const QString& trouble) {
    m_trouble = trouble;
    setToolTip(trouble);
}

void AlarmPanel::setReadOnly(bool on) {
    m_acknowledge->setVisible(!on);
    m_mute->setVisible(!on);
    m_fitted.clear();
    fitHead();
    m_list->setAccessibleName(on ? tr("Alarms, newest first")
                                 : tr("Alarms, newest first; Return acknowledges the chosen one"));
}

void AlarmPanel::refresh() {
    const int count = m_model.rowCount();
    bool waits = false;
    for (int row = 0; row < count; ++row) waits = waits || !m_model.line(row)->acknowledged;
    m_list->setVisible(count > 0);
    m_calm->setVisible(count == 0);
    m_acknowledge->setEnabled(waits);
    m_mute->setChecked(!m_muted.isEmpty());
    m_mute->setAccessibleName(m_muted.isEmpty() ? tr("Mute tones for one minute") : m_muted);
    fitHead();
}

void AlarmPanel::fitHead() {
    const int count = m_model.rowCount();
    const QString number = QString::number(count);
    const QString title = count == 0 ? tr("Alarms") : tr("Alarms · %1").arg(count);
    const QString mute = m_muted.isEmpty() ? tr("M Mute") : tr("M %1").arg(m_muted);
    const QString brief = m_muted.isEmpty() ? mute : tr("M %1").arg(m_mutedBrief);
    const QString acknowledge = tr("⌫ Acknowledge"), key = QStringLiteral("⌫");
    // Called three times a second: nothing is done while texts and width stay the same.
    const QString wanted = QStringList{title, mute, QString::number(width())}.join(QLatin1Char('\n'));
    if (std::exchange(m_fitted, wanted) == wanted) return;
    m_title->setAccessibleName(title);
    const std::tuple<QString, QString, QString> ways[] = {{title, mute, acknowledge},
                                                          {title, mute, key},
                                                          {title, brief, key},
                                                          {count == 0 ? QString() : number, brief, key}};
    for (QWidget* part : {static_cast<QWidget*>(m_title), static_cast<QWidget*>(m_mute),
                          static_cast<QWidget*>(m_acknowledge)})
        part->ensurePolished();  // the style adds to their size
    for (const auto& [first, second, third] : ways) {
        m_title->setText(first);
        m_mute->setText(second);
        m_acknowledge->setText(third);
        m_head->invalidate();
        if (m_head->minimumSize().width() <= width()) return;
    }
}

void AlarmPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitHead();
}

void AlarmPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange) {
        m_list->viewport()->update();
        m_fitted.clear();
        fitHead();
    }
    QWidget::changeEvent(event);
}

}  // namespace leitstand
