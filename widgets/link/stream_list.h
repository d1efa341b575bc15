#pragma once

#include <vector>

#include <QTableView>

#include "widgets/models/live/robots/stream_table.h"

namespace leitstand {

/// A table of the streams of all robots, one row each. Columns that do not fit are hidden, the least
/// important first.
class StreamList final : public QTableView {
    Q_OBJECT
public:
    explicit StreamList(StreamTable::Of of, QWidget* parent = nullptr);

    void setRows(std::vector<StreamRow> rows) { m_streams.setRows(std::move(rows)); }
    [[nodiscard]] const StreamTable& streams() const { return m_streams; }
    /// The selected stream; null: none.
    [[nodiscard]] const StreamRow* chosen() const { return m_streams.row(currentIndex().row()); }

signals:
    void chosenChanged();

private:
    StreamTable m_streams;
};

}  // namespace leitstand
