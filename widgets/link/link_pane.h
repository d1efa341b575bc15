#pragma once

#include <vector>

#include <QWidget>

#include "core/robot/streams/stream_request.h"
#include "widgets/models/live/robots/stream_table.h"

class QAction;
class QCheckBox;
class QLabel;

namespace leitstand {

class NumberBox;
class StreamList;

/// Shows how much of the link each stream of each robot uses, and what the operator requests of it. It has a
/// table, an editor for the selected stream, the total, and switch and budget of the thin link.
class LinkPane final : public QWidget {
    Q_OBJECT
public:
    /// @p thin: command that switches the thin link, shown as a button.
    explicit LinkPane(QAction& thin, QWidget* parent = nullptr);

    /// @p megabits: total of all robots [Mbit/s]. @p thin: whether the thin link is on. @p budget: capacity
    /// of a thin link [Mbit/s].
    void show(std::vector<StreamRow> rows, double megabits, bool thin, double budget);
    using QWidget::show;
    [[nodiscard]] const StreamTable& table() const;

signals:
    void requested(const QString& robot, const QString& topic, const leitstand::StreamRequest& request);
    void budgetChosen(double megabits);
    /// The operator chose the cloud that makes the map.
    void mapChosen(const QString& robot, const QString& topic);

private:
    QWidget* editor();
    QWidget* foot(QAction& thin);
    void showChosen();
    void showMaps();  ///< shows whether the selected stream makes the map
    void takeOver();

    StreamList* m_list;
    QLabel *m_total, *m_chosen;
    QCheckBox *m_enabled, *m_maps;
    NumberBox *m_rate, *m_quality, *m_width, *m_budget;
    bool m_showing = false;  ///< whether the fields are being filled from the model
};

}  // namespace leitstand
