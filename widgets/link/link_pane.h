#pragma once

#include <vector>

#include <QWidget>

#include "core/robot/streams/stream_wish.h"
#include "widgets/models/live/robots/stream_table.h"

class QAction;
class QCheckBox;
class QLabel;

namespace leitstand {

class NumberBox;
class StreamList;

/// What every stream of every robot takes of the link, and what is asked of them: a table, an editor for the
/// chosen stream, the total, the switch of the thin link and its budget.
class LinkPane final : public QWidget {
    Q_OBJECT
public:
    /// @p thin: the command that switches the thin link, shown as a button.
    explicit LinkPane(QAction& thin, QWidget* parent = nullptr);

    /// @p megabits: of all robots together [Mbit/s]; @p budget: of the thin link.
    void show(std::vector<StreamRow> rows, double megabits, bool thin, double budget);
    using QWidget::show;
    [[nodiscard]] const StreamTable& table() const;

signals:
    void wished(const QString& robot, const QString& topic, const leitstand::StreamWish& wish);
    void budgetChosen(double megabits);

private:
    QWidget* editor();
    QWidget* foot(QAction& thin);
    void showChosen();
    void takeOver();

    StreamList* m_list;
    QLabel *m_total, *m_chosen;
    QCheckBox* m_enabled;
    NumberBox *m_rate, *m_quality, *m_width, *m_budget;
    bool m_showing = false;  ///< what the fields show comes from the model
};

}  // namespace leitstand
