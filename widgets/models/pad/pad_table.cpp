#include "widgets/models/pad/pad_table.h"

#include <utility>

namespace leitstand {

void PadTable::setCommands(std::vector<PadCommandFace> commands) {
    beginResetModel();
    m_commands = std::move(commands);
    m_row = -1;
    endResetModel();
}

void PadTable::setBindings(const PadBindings& bindings) {
    m_bindings = m_used = bindings;
    m_row = -1;
    m_capture.reset();
    publishChange();
}

void PadTable::reset() {
    m_bindings = defaultBindings(m_bindings.layout);
    m_row = -1;
    m_capture.reset();
    publishChange();
}

void PadTable::setShape(double deadZone, double expo, double press) {
    m_bindings.deadZone = deadZone;
    m_bindings.expo = expo;
    m_bindings.press = press;
    emit changed();
}

QString PadTable::fault() const {
    const bool stops = m_bindings.at(PadAction::Stop).kind != PadControl::Kind::None;
    return stops ? QString() : tr("“%1” needs a control.").arg(padActionName(PadAction::Stop));
}

void PadTable::publishChange() {
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    emit changed();
}

void PadTable::setState(const PadState& state) {
    if (state == m_state) return;
    const PadState before = std::exchange(m_state, state);
    for (int row = 0; row < rowCount(); ++row) {
        if (amountOf(control(row), before) != amountOf(control(row), m_state))
            emit dataChanged(index(row, Control), index(row, Control), {AmountRole});
    }
    if (!state.connected) capture(-1);
    if (!m_capture) return;
    const auto pushed = m_capture->update(state);
    if (!pushed) return;
    const int row = std::exchange(m_row, -1);
    m_capture.reset();
    if (!bindRow(row, *pushed)) {
        emit refused(tr("%1 stops all robots, and does nothing else.")
                         .arg(padControlName(*pushed, m_bindings.layout)));
    }
    publishChange();
}

void PadTable::capture(int row) {
    if (row == m_row) return;
    const int before = std::exchange(m_row, row);
    m_capture = row >= 0 ? std::optional<PadCapture>(m_state) : std::nullopt;
    for (const int one : {before, row}) {
        if (one >= 0) emit dataChanged(index(one, Control), index(one, Control));
    }
    emit changed();
}

bool PadTable::canClear(int row) const {
    return control(row).kind != PadControl::Kind::None && actionAt(row) != PadAction::Stop;
}

void PadTable::clear(int row) {
    if (!canClear(row) || !bindRow(row, {})) return;
    publishChange();
}

std::optional<PadAction> PadTable::actionAt(int row) const {
    const auto i = static_cast<std::size_t>(row);
    return row >= 0 && i < PadActionCount ? std::optional(padActions()[i]) : std::nullopt;
}

bool PadTable::bindRow(int row, const PadControl& control) {
    if (const auto action = actionAt(row)) return bindPad(m_bindings, *action, control);
    return bindPad(m_bindings, m_commands[static_cast<std::size_t>(row) - PadActionCount].id, control);
}

PadControl PadTable::control(int row) const {
    if (const auto action = actionAt(row)) return m_bindings.at(*action);
    const auto i = static_cast<std::size_t>(row) - PadActionCount;
    return row >= 0 && i < m_commands.size() ? controlOf(m_bindings, m_commands[i].id) : PadControl{};
}

int PadTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(PadActionCount + m_commands.size());
}

int PadTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant PadTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const int row = index.row();
    const auto action = actionAt(row);
    const PadCommandFace* const command =
        action ? nullptr : &m_commands[static_cast<std::size_t>(row) - PadActionCount];
    if (role == AmountRole) return amountOf(control(row), m_state);
    if (role == Qt::ToolTipRole) return action ? padActionHint(*action) : command->hint;
    if (role != Qt::DisplayRole && role != Qt::AccessibleTextRole) return {};
    if (index.column() == Action) return action ? padActionName(*action) : command->text;
    return row == m_row ? tr("push it now …") : padControlName(control(row), m_bindings.layout);
}

QVariant PadTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    return section == Action ? tr("does") : tr("control");
}

}  // namespace leitstand
