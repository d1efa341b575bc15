#include "widgets/models/live/alarm_list_model.h"

#include <algorithm>

namespace leitstand {
namespace {

QString wholeText(const AlarmLine& line) {
    const QString who = line.face.title.isEmpty() ? AlarmListModel::tr("Station") : line.face.title;
    const QString how =
        line.severity == AlarmSeverity::Act ? AlarmListModel::tr("Act") : AlarmListModel::tr("Look");
    QString text = QStringLiteral("%1 · %2: %3 · %4").arg(how, who, line.text, line.since);
    if (line.acknowledged) text += AlarmListModel::tr(" · acknowledged");
    return text;
}

}  // namespace

void AlarmListModel::setLines(const std::vector<AlarmLine>& lines) {
    if (lines == m_lines) return;
    const bool same = std::equal(lines.begin(), lines.end(), m_lines.begin(), m_lines.end(),
                                 [](const AlarmLine& a, const AlarmLine& b) { return a.id == b.id; });
    if (same) {
        m_lines = lines;
        emit dataChanged(index(0), index(rowCount() - 1));
        return;
    }
    beginResetModel();
    m_lines = lines;
    endResetModel();
}

const AlarmLine* AlarmListModel::line(int row) const {
    return row < 0 || row >= rowCount() ? nullptr : &m_lines[static_cast<std::size_t>(row)];
}

int AlarmListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

QVariant AlarmListModel::data(const QModelIndex& index, int role) const {
    const AlarmLine* const shown = line(index.row());
    if (shown == nullptr) return {};
    switch (role) {
        case Qt::DisplayRole:
            return shown->text;
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            return wholeText(*shown);
        case ToneRole:
            return static_cast<int>(shown->tone);
        case LineRole:
            return QVariant::fromValue(*shown);
        default:
            return {};
    }
}

}  // namespace leitstand
