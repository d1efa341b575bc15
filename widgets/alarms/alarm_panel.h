#pragma once

#include <QWidget>

#include "widgets/models/live/alarm_list_model.h"

class QHBoxLayout;
class QLabel;
class QListView;
class QToolButton;

namespace leitstand {

/// All alarms, newest first: how loud (by shape and colour), whose, what, and for how long. Acknowledges and
/// mutes; never a box in the way of who drives.
class AlarmPanel final : public QWidget {
    Q_OBJECT
public:
    explicit AlarmPanel(QWidget* parent = nullptr);

    /// alarmLinesOf() all alarms; @p mute, @p brief: muteText(), muteBrief().
    void show(const std::vector<AlarmLine>& lines, const QString& mute, const QString& brief = {});
    using QWidget::show;
    /// What the operator has to know of the tones: "no sound device"; empty: they are heard.
    void setSoundTrouble(const QString& trouble);
    /// Alarms of the past are only looked at.
    void setReadOnly(bool on);

    [[nodiscard]] QSize sizeHint() const override { return {320, 160}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {188, 90}; }

signals:
    void acknowledged(const leitstand::AlarmId& id);  ///< this one
    void newestAcknowledged();
    void muteToggled();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void fitHead();  ///< words of the head give way to its numbers and keys

    AlarmListModel m_model;
    QListView* m_list;
    QHBoxLayout* m_head;
    QLabel *m_title, *m_calm;
    QToolButton *m_acknowledge, *m_mute;
    QString m_muted, m_mutedBrief, m_trouble;
    QString m_fitted;  ///< what the head was fitted for
};

}  // namespace leitstand
