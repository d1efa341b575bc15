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

/// Returns what a check found: "connected, 22 ms", "brake: stands after 0.31 s and 2 cm".
[[nodiscard]] QString checkText(const PreflightCheck& check);
/// Returns what the operator can do about it; empty when nothing has to be done.
[[nodiscard]] QString remedyText(const PreflightCheck& check);
/// Returns "✓", "!" or "✗": a shape for each state, so that colour is not alone.
[[nodiscard]] QString stateMark(CheckState state);
/// "in order", "needs a look", "must be mended".
[[nodiscard]] QString stateText(CheckState state);
[[nodiscard]] Tone toneOf(CheckState state);
/// Returns the verdict on all @p checks in a line: "All in order", "2 must be mended, 1 needs a look".
[[nodiscard]] QString verdictText(const std::vector<PreflightCheck>& checks);
/// Returns the state of a brake test for the page: "Let go of the sticks ...", "Drives ...", its result.
[[nodiscard]] QString brakeText(BrakeTest::Phase phase, const BrakeResult& result);

/// The preflight page's checks, a row each, robot by robot.
class PreflightList final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { State, Who, What, Remedy, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// @p faces: of the robots that checks name.
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
