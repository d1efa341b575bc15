#pragma once

#include <QWidget>

#include "core/base/time.h"
#include "widgets/models/timeline/timeline_axis.h"

class QAction;
class QHBoxLayout;
class QLabel;

namespace leitstand {

/// Controls a review: its commands as buttons in a row, its present moment and its speed.
class TransportBar final : public QWidget {
    Q_OBJECT
public:
    explicit TransportBar(QWidget* parent = nullptr);

    /// Adds a button for @p action at the end of the row.
    void addCommand(QAction& action);
    void addGap();
    /// Shows the moment @p at on @p axis. @p rate: how many times as fast as real time.
    void show(const TimelineAxis& axis, Time at, double rate);
    using QWidget::show;

private:
    QHBoxLayout* m_buttons;
    QLabel *m_time, *m_rate;
};

}  // namespace leitstand
