#pragma once

#include <map>
#include <string>
#include <vector>

#include <QAbstractTableModel>
#include <QString>

#include "core/station/preflight/preflight.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// Returns what a check found: "connected, round trip 22 ms", "brake: stands after 310 ms and 2 cm without
/// commands".
[[nodiscard]] QString checkText(const PreflightCheck& check);
/// Returns what the operator can do about the result of @p check; empty when nothing needs to be done.
[[nodiscard]] QString remedyText(const PreflightCheck& check);
/// Returns "✓", "–", "!" or "✗". Each state has its own shape, so that colour is not the only difference.
[[nodiscard]] QString stateMark(CheckState state);
/// "in order", "to know", "needs a look", "must be mended".
[[nodiscard]] QString stateText(CheckState state);
[[nodiscard]] Tone toneOf(CheckState state);
/// Returns a summary of all @p checks on one line: "All in order", "2 to be mended, 1 to be looked at".
[[nodiscard]] QString verdictText(const std::vector<PreflightCheck>& checks);
/// Returns the state of a brake test for the page: while it runs, "Drives ... keep holding" and similar texts
/// for @p phase, then @p result.
[[nodiscard]] QString brakeText(BrakeTest::Phase phase, const BrakeResult& result);

/// The checks of the preflight page, one row each, robot by robot.
class PreflightList final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { State, Who, What, Remedy, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// @p faces: faces of the robots in the checks, by the robots' names.
    void setChecks(std::vector<PreflightCheck> checks, std::map<std::string, RobotFace> faces);
    [[nodiscard]] const std::vector<PreflightCheck>& checks() const { return m_checks; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] QString whoText(const PreflightCheck& check) const;

    std::vector<PreflightCheck> m_checks;
    std::map<std::string, RobotFace> m_faces;
};

}  // namespace leitstand
