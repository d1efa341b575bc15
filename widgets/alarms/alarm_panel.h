#pragma once

#include <QWidget>

#include "widgets/models/live/alarm_list_model.h"

class QHBoxLayout;
class QLabel;
class QListView;
class QToolButton;

namespace leitstand {

/// Lists all alarms, newest first: severity (by shape and colour), robot, text and age. Emits requests to
/// acknowledge and to mute. It never opens a dialog in front of the driver.
class AlarmPanel final : public QWidget {
    Q_OBJECT
public:
    explicit AlarmPanel(QWidget* parent = nullptr);

    /// Shows @p lines, made by alarmLinesOf(). @p mute: muteText(); empty: tones are not muted. @p brief:
    /// muteBrief(), shown if there is no space for @p mute.
    void show(const std::vector<AlarmLine>& lines, const QString& mute, const QString& brief = {});
    using QWidget::show;
    /// Shows why tones cannot be heard: "no sound device". Empty: they are heard.
    void setSoundTrouble(const QString& trouble);
    /// Hides the buttons that acknowledge and mute while @p on, for example for alarms of a past mission.
    /// Activating a row still emits acknowledged().
    void setReadOnly(bool on);

    [[nodiscard]] QSize sizeHint() const override { return {320, 160}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {188, 90}; }

signals:
    void acknowledged(const leitstand::AlarmId& id);  ///< the operator activated the row of alarm @p id
    void newestAcknowledged();
    void muteToggled();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void fitHead();  ///< shortens the words of the header, then removes them; numbers and keys remain

    AlarmListModel m_model;
    QListView* m_list;
    QHBoxLayout* m_head;
    QLabel *m_title, *m_calm;
    QToolButton *m_acknowledge, *m_mute;
    QString m_muted, m_mutedBrief, m_trouble;
    QString m_fitted;  ///< texts and width for which the header was last fitted
};

}  // namespace leitstand
