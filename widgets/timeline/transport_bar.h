#pragma once

#include <QWidget>

#include "core/base/time.h"
#include "widgets/models/timeline/timeline_axis.h"

class QAction;
class QHBoxLayout;
class QLabel;

namespace leitstand {

/// What moves a review: its commands as buttons in a row, and where and how fast it is.
class TransportBar final : public QWidget {
    Q_OBJECT
public:
    explicit TransportBar(QWidget* parent = nullptr);

    /// Puts @p action's button at the end of the row.
    void addCommand(QAction& action);
    void addGap();
    /// Where it is on @p axis, and its rate: of mission's time to real time.
    void show(const TimelineAxis& axis, Time at, double rate);
    using QWidget::show;

private:
    QHBoxLayout* m_buttons;
    QLabel *m_time, *m_rate;
};

}  // namespace leitstand
