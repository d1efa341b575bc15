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

/// Shows how much of the link each stream of each robot uses, and what the operator requests of the stream.
/// Has a table, an editor for the chosen stream, the total, and switch and budget of the thin link.
class LinkPane final : public QWidget {
    Q_OBJECT
public:
    /// @p thin: command that switches the thin link, shown as a button.
    explicit LinkPane(QAction& thin, QWidget* parent = nullptr);

    /// @p megabits: total of all robots [Mbit/s]. @p thin: the thin link is on. @p budget: what a thin link
    /// may carry [Mbit/s].
    void show(std::vector<StreamRow> rows, double megabits, bool thin, double budget);
    using QWidget::show;
    [[nodiscard]] const StreamTable& table() const;

signals:
    void requested(const QString& robot, const QString& topic, const leitstand::StreamRequest& request);
    void budgetChosen(double megabits);
    void mapChosen(const QString& robot, const QString& topic);  ///< the cloud that is to make the map

private:
    QWidget* editor();
    QWidget* foot(QAction& thin);
    void showChosen();
    void showMaps();  ///< whether the chosen stream makes the map
    void takeOver();

    StreamList* m_list;
    QLabel *m_total, *m_chosen;
    QCheckBox *m_enabled, *m_maps;
    NumberBox *m_rate, *m_quality, *m_width, *m_budget;
    bool m_showing = false;  ///< the fields are being filled from the model
};

}  // namespace leitstand
