#include "widgets/models/scan_list_model.h"

#include <algorithm>
#include <utility>

#include "widgets/models/scan_texts.h"
#include "widgets/models/tone.h"
#include "widgets/models/verdict.h"

namespace leitstand {
namespace {

Tone toneOf(const MapScan& scan, int column) {
    const Verdict verdict = verdictOf(scan);
    if (verdict == Verdict::Reference) {
        return column >= ScanListModel::Iterations ? Tone::Muted : Tone::Normal;
    }
    return column == ScanListModel::Certainty && verdict != Verdict::Certain ? Tone::Attention : Tone::Normal;
}

Qt::Alignment alignmentOf(int column) {
    const bool text = column == ScanListModel::Name || column == ScanListModel::Certainty;
    return Qt::AlignVCenter | (text ? Qt::AlignLeft : Qt::AlignRight);
}

}  // namespace

void ScanListModel::setMap(MapPtr map) {
    const int before = rowCount(), after = static_cast<int>(map->scans.size());
    if (after > before) beginInsertRows({}, before, after - 1);
    if (after < before) beginRemoveRows({}, after, before - 1);
    m_map = std::move(map);
    m_visible.resize(static_cast<std::size_t>(after), true);
    if (after > before) endInsertRows();
    if (after < before) endRemoveRows();
    if (const int kept = std::min(before, after); kept > 0) {
        emit dataChanged(index(0, 0), index(kept - 1, ColumnCount - 1));
    }
}

void ScanListModel::setAllVisible(bool visible) {
    if (m_visible.empty()) return;
    m_visible.assign(m_visible.size(), visible);
    emit dataChanged(index(0, Name), index(rowCount() - 1, Name), {Qt::CheckStateRole});
    emit visibilityChanged(m_visible);
}

int ScanListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_map->scans.size());
}

int ScanListModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ScanListModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const auto row = static_cast<std::size_t>(index.row());
    const MapScan& scan = m_map->scans[row];
    switch (role) {
        case Qt::DisplayRole:
            return scanText(scan, Column(index.column()));
        case Qt::ToolTipRole:
            return scanHint(scan, Column(index.column()));
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(alignmentOf(index.column()));
        case Qt::CheckStateRole:
            if (index.column() != Name) return {};
            return static_cast<int>(m_visible[row] ? Qt::Checked : Qt::Unchecked);
        case ToneRole:
            return static_cast<int>(toneOf(scan, index.column()));
        default:
            return {};
    }
}

bool ScanListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return false;
    if (index.column() != Name || role != Qt::CheckStateRole) return false;
    m_visible[static_cast<std::size_t>(index.row())] = value.toInt() == Qt::Checked;
    emit dataChanged(index, index, {Qt::CheckStateRole});
    emit visibilityChanged(m_visible);
    return true;
}

Qt::ItemFlags ScanListModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags plain = QAbstractTableModel::flags(index);
    return index.column() == Name ? plain | Qt::ItemIsUserCheckable : plain;
}

QVariant ScanListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) return {};
    switch (role) {
        case Qt::DisplayRole:
            return columnTitle(Column(section));
        case Qt::ToolTipRole:
            return columnHint(Column(section));
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(alignmentOf(section));
        default:
            return {};
    }
}

}  // namespace leitstand
