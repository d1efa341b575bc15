#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <QString>

#include "core/robot/joints/joint_control.h"
#include "core/robot/robot_description.h"
#include "widgets/models/text_rows_model.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// An axis of a robot's joints: what one control moves.
struct JointAxisId {
    std::string group;
    std::size_t axis = 0;
    friend bool operator==(const JointAxisId&, const JointAxisId&) = default;
};

/// All groups of a robot now, by name.
using JointGroupViews = std::map<std::string, JointGroupView>;

/// Returns all axes of @p robot, in the order of its file.
[[nodiscard]] std::vector<JointAxisId> jointAxes(const RobotDescription& robot);

/// One axis for the operator.
struct JointRow {
    JointAxisId id;
    QString title;     ///< "Front flippers"
    QString position;  ///< "30°", "30° / 12°" where its joints differ, "0.120 m", "–" when unknown
    QString joints;    ///< its joints with their positions and limits, for the tooltip
    friend bool operator==(const JointRow&, const JointRow&) = default;
};
[[nodiscard]] std::vector<JointRow> jointRows(const RobotDescription& robot, const JointGroupViews& now);

/// Returns what the group of an axis does, or why it does not move; empty: it rests and could be moved.
[[nodiscard]] QString jointStatus(const JointGroup& group, const JointGroupView& now);
[[nodiscard]] Tone jointTone(const JointGroupView& now);

/// The axes of a robot as rows of a table.
class JointRowsModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Title, Position, Columns };
    using TextRowsModel::TextRowsModel;

    void show(const std::vector<JointRow>& rows);
    [[nodiscard]] const std::vector<JointRow>& rows() const { return m_rows; }

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;

private:
    std::vector<JointRow> m_rows;
};

}  // namespace leitstand
