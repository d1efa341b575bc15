#include "app/window/scans/bottom_strip.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

#include "app/services/offline/scan_session.h"
#include "widgets/models/message_list_model.h"
#include "widgets/painting/progress_strip.h"

namespace leitstand {
namespace {

QString progressText(const SessionProgress& progress) {
    const QString name = QString::fromStdString(progress.name);
    if (progress.scans == 0) return BottomStrip::tr("Reading %1").arg(name);
    const QString text = progress.step == SessionProgress::Step::Reading
                             ? BottomStrip::tr("Reading %1 · %2 of %3")
                             : BottomStrip::tr("Registering %1 · %2 of %3");
    return text.arg(name, QString::number(progress.scan), QString::number(progress.scans));
}

QString countText(int errors, int messages) {
    if (errors == 1) return BottomStrip::tr("▲ 1 error");
    if (errors > 1) return BottomStrip::tr("▲ %1 errors").arg(errors);
    if (messages == 1) return BottomStrip::tr("1 message");
    if (messages > 1) return BottomStrip::tr("%1 messages").arg(messages);
    return BottomStrip::tr("No messages");
}

}  // namespace

BottomStrip::BottomStrip(QAction& cancel, QAction& messages, const MessageListModel& list, QWidget* parent)
    : QWidget(parent),
      m_pick(new QLabel(this)),
      m_measurement(new QLabel(this)),
      m_progress(new ProgressStrip(cancel, this)),
      m_messages(new QToolButton(this)) {
    m_pick->setObjectName(QStringLiteral("pick"));
    m_measurement->setObjectName(QStringLiteral("measurement"));
    m_pick->setProperty("muted", true);
    m_messages->setObjectName(QStringLiteral("messageCount"));
    m_messages->setProperty("quiet", true);
    m_messages->setToolTip(messages.toolTip());
    connect(m_messages, &QToolButton::clicked, &messages, &QAction::trigger);

    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(10, 0, 6, 0);
    line->setSpacing(20);
    line->addWidget(m_measurement);
    line->addWidget(m_pick);
    line->addStretch(1);
    line->addWidget(m_progress);
    line->addWidget(m_messages);
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
        connect(&list, signal, this, [this, &list] { showCount(list); });
    }
    showCount(list);
}

void BottomStrip::setPick(const QString& text) {
    m_pick->setText(text);
}

void BottomStrip::setMeasurement(const QString& text) {
    m_measurement->setText(text);
    m_measurement->setVisible(!text.isEmpty());
}

void BottomStrip::setNote(const QString& text) {
    m_pick->setText(text);
}

void BottomStrip::showProgress(const SessionProgress& progress) {
    m_progress->show(progressText(progress), progress.fraction);
}

void BottomStrip::hideProgress() {
    m_progress->hide();
}

void BottomStrip::showCount(const MessageListModel& list) {
    const int errors = list.errorCount();
    m_messages->setText(countText(errors, list.rowCount()));
    m_messages->setProperty("loud", errors > 0);
    m_messages->style()->unpolish(m_messages);
    m_messages->style()->polish(m_messages);
}

}  // namespace leitstand
