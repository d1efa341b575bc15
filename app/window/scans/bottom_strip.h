#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace leitstand {

class MessageListModel;
class ProgressStrip;
struct SessionProgress;

/// The strip along the window's bottom: what the pointer is on, what was measured, the work in progress, and
/// the number of messages.
class BottomStrip final : public QWidget {
    Q_OBJECT
public:
    /// @p cancel: ends the work. @p messages: shows the list of messages @p list.
    BottomStrip(QAction& cancel, QAction& messages, const MessageListModel& list, QWidget* parent = nullptr);

    void setPick(const QString& text);
    /// Shows a measurement, or how to make one, until the next call.
    void setMeasurement(const QString& text);
    /// Shows something that succeeded, at the place of setPick() and until its next call.
    void setNote(const QString& text);
    void showProgress(const SessionProgress& progress);
    void hideProgress();

private:
    void showCount(const MessageListModel& list);

    QLabel* m_pick;
    QLabel* m_measurement;
    ProgressStrip* m_progress;
    QToolButton* m_messages;
};

}  // namespace leitstand
