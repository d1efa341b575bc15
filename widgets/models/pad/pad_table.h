#pragma once

#include <optional>
#include <vector>

#include <QAbstractTableModel>

#include "core/station/pad/pad_capture.h"
#include "widgets/models/pad/pad_texts.h"

namespace leitstand {

/// What a gamepad can do and with which control, one row each: first driving and STOP, then commands. To bind
/// a row, call capture(), then setState() until a control is pushed.
class PadTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Action, Control, ColumnCount };
    /// How far the row's control is pushed, 0 to 1.
    static constexpr int AmountRole = Qt::UserRole + 2;

    using QAbstractTableModel::QAbstractTableModel;

    void setCommands(std::vector<PadCommandFace> commands);
    /// Sets the bindings in use. Discards changes that were made here.
    void setBindings(const PadBindings& bindings);
    [[nodiscard]] const PadBindings& bindings() const { return m_bindings; }
    [[nodiscard]] const PadState& state() const { return m_state; }
    /// Whether the bindings were changed here and are not in use yet.
    [[nodiscard]] bool isChanged() const { return m_bindings != m_used; }
    /// Returns why the bindings cannot be used; empty: they can.
    [[nodiscard]] QString fault() const;

    void setState(const PadState& state);
    void setShape(double deadZone, double expo, double press);
    void reset();           ///< sets the default bindings of this layout
    void capture(int row);  ///< binds the next pushed control to the row; -1: stops waiting for a control
    [[nodiscard]] int captured() const { return m_row; }
    void clear(int row);
    [[nodiscard]] bool canClear(int row) const;
    [[nodiscard]] PadControl control(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    void changed();                    ///< the bindings changed, or the wait for a control began or ended
    void refused(const QString& why);  ///< the control that was pushed cannot be used for the row

private:
    [[nodiscard]] std::optional<PadAction> actionAt(int row) const;
    [[nodiscard]] bool bindRow(int row, const PadControl& control);
    void publishChange();

    PadBindings m_bindings, m_used;
    std::vector<PadCommandFace> m_commands;
    PadState m_state;
    std::optional<PadCapture> m_capture;
    int m_row = -1;
};

}  // namespace leitstand
