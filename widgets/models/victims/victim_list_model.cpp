#include "widgets/models/victims/victim_list_model.h"

#include <algorithm>
#include <utility>

#include "core/event/find_sample.h"

namespace leitstand {

VictimListModel::VictimListModel(std::vector<Column> columns, QObject* parent)
    : TextRowsModel(parent), m_columns(std::move(columns)) {}

void VictimListModel::setRows(const std::vector<VictimRow>& rows) {
    replace(m_rows, rows,
            [](const auto& a, const auto& b) { return a.find == b.find && a.candidate == b.candidate; });
}

const VictimRow* VictimListModel::row(int row) const {
    return row < 0 || row >= rowCount() ? nullptr : &m_rows[static_cast<std::size_t>(row)];
}

int VictimListModel::rowOf(const FindKey& find) const {
    const auto found = std::find_if(m_rows.begin(), m_rows.end(),
                                    [&](const VictimRow& row) { return row.filed() && row.find == find; });
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

int VictimListModel::placeOf(Column column) const {
    const auto found = std::find(m_columns.begin(), m_columns.end(), column);
    return found == m_columns.end() ? -1 : static_cast<int>(found - m_columns.begin());
}

QString VictimListModel::hint(int row) const {
    const VictimRow& shown = m_rows[static_cast<std::size_t>(row)];
    QStringList parts = {shown.name,  shown.what,  shown.state, shown.where,
                         shown.since, shown.place, shown.moved, shown.signs};
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

Tone VictimListModel::tone(int row, int column) const {
    const VictimRow& shown = m_rows[static_cast<std::size_t>(row)];
    // A discarded find has its tone in all cells, others only in the state.
    const bool whole = shown.discarded || m_columns[static_cast<std::size_t>(column)] == State;
    return whole ? shown.tone : Tone::Normal;
}

QString VictimListModel::cell(int row, int column) const {
    const VictimRow& shown = m_rows[static_cast<std::size_t>(row)];
    switch (m_columns[static_cast<std::size_t>(column)]) {
        case Name:
            return shown.name;
        case State:
            return shown.find.first == FindSample::Kind::Victim
                       ? shown.state
                       : tr("%1, %2", "hazard, confirmed").arg(shown.what, shown.state);
        case Where:
            return shown.where;
        case Found:
            return shown.since;
        case Signs:
            return shown.signs;
    }
    return {};
}

QStringList VictimListModel::headers() const {
    QStringList all;
    for (const Column column : m_columns) {
        switch (column) {
            case Name:
                all += tr("Find");
                break;
            case State:
                all += tr("State");
                break;
            case Where:
                all += tr("Where");
                break;
            case Found:
                all += tr("Found", "when");
                break;
            case Signs:
                all += tr("Signs");
                break;
        }
    }
    return all;
}

}  // namespace leitstand
