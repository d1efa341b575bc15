#include "widgets/models/live/preflight/preflight_list.h"

#include <utility>

#include "widgets/models/others_text.h"

namespace leitstand {

void PreflightList::setChecks(std::vector<PreflightCheck> checks, std::map<std::string, RobotFace> faces) {
    m_faces = std::move(faces);
    if (checks.size() != m_checks.size()) {
        beginResetModel();
        m_checks = std::move(checks);
        endResetModel();
        return;
    }
    m_checks = std::move(checks);
    if (!m_checks.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int PreflightList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_checks.size());
}

int PreflightList::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString PreflightList::whoText(const PreflightCheck& check) const {
    if (check.robot.empty()) return tr("Station");
    const auto face = m_faces.find(check.robot);
    return face == m_faces.end() ? othersText(check.robot) : face->second.title;
}

QVariant PreflightList::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const PreflightCheck& check = m_checks[static_cast<std::size_t>(index.row())];
    const auto column = Column(index.column());
    switch (role) {
        case Qt::DisplayRole:
            if (column == State) return stateMark(check.state);
            if (column == Who) {
                // Each name once, at its first line.
                const bool first = index.row() == 0 ||
                                   m_checks[static_cast<std::size_t>(index.row() - 1)].robot != check.robot;
                return first ? whoText(check) : QString();
            }
            return column == What ? checkText(check) : remedyText(check);
        case Qt::ToolTipRole:
            return column == State ? stateText(check.state)
                                   : QStringLiteral("%1: %2").arg(whoText(check), checkText(check));
        case Qt::AccessibleTextRole:
            if (column != State) return {};
            return QStringLiteral("%1: %2").arg(whoText(check), stateText(check.state));
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::AlignVCenter |
                                       (column == State ? Qt::AlignHCenter : Qt::AlignLeft));
        case ToneRole:
            if (column == Remedy) return static_cast<int>(Tone::Muted);
            if (column == Who || check.state <= CheckState::Note)
                return static_cast<int>(column == State ? Tone::Muted : Tone::Normal);
            return static_cast<int>(toneOf(check.state));
        default:
            return {};
    }
}

QVariant PreflightList::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Who:
            return tr("Of");
        case What:
            return tr("Check");
        case Remedy:
            return tr("What to do");
        default:
            return QString();
    }
}

}  // namespace leitstand
