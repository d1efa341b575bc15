#include "widgets/models/victims/victim_list_model.h"

#include <algorithm>

namespace leitstand {

void VictimListModel::setRows(const std::vector<VictimRow>& rows) {
    if (rows == m_rows) return;
    const bool same = std::equal(
        rows.begin(), rows.end(), m_rows.begin(), m_rows.end(),
        [](const auto& a, const auto& b) { return a.find == b.find && a.candidate == b.candidate; });
    if (same) {
        m_rows = rows;
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_rows = rows;
    endResetModel();
}

const VictimRow* VictimListModel::row(int row) const {
    return row < 0 || row >= rowCount() ? nullptr : &m_rows[static_cast<std::size_t>(row)];
}

int VictimListModel::rowOf(const FindKey& find) const {
    const auto found = std::find_if(m_rows.begin(), m_rows.end(),
                                    [&](const VictimRow& row) { return row.filed() && row.find == find; });
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

int VictimListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int VictimListModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant VictimListModel::data(const QModelIndex& index, int role) const {
    const VictimRow* const shown = row(index.row());
    if (shown == nullptr) return {};
    if (role == ToneRole) return static_cast<int>(index.column() == State ? shown->tone : Tone::Normal);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) {
        return QStringLiteral("%1 · %2 · %3 · %4 · %5")
            .arg(shown->name, shown->what, shown->state, shown->where, shown->signs);
    }
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case Name:
            return shown->name;
        case State:
            return shown->find.first == VictimSample::Kind::Victim
                       ? shown->state
                       : tr("%1, %2", "hazard, confirmed").arg(shown->what, shown->state);
        case Where:
            return shown->where;
        case Signs:
            return shown->signs;
        default:
            return {};
    }
}

QVariant VictimListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Name:
            return tr("Find");
        case State:
            return tr("State");
        case Where:
            return tr("Where");
        case Signs:
            return tr("Signs");
        default:
            return {};
    }
}

}  // namespace leitstand
