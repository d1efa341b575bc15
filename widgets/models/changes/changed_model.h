#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/mapping/comparison/map_changes.h"
#include "widgets/models/text_rows_model.h"

namespace leitstand {

/// Something that is new or has disappeared, as a row of a list.
struct ChangedRow {
    int number = 0;                                   ///< from 1; the largest thing has 1
    QString what;                                     ///< "new" or "gone"
    QString size;                                     ///< "0.6 × 0.5 × 1.1 m"
    QString where;                                    ///< from the robot: "3.2 m, 40° left"
    QString place;                                    ///< "x 1.2, y −0.5"
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< middle of the thing [m]
    friend bool operator==(const ChangedRow&, const ChangedRow&) = default;
};

/// Returns the rows of @p changes. @p robotInMap: pose of the selected robot; empty: unknown.
[[nodiscard]] std::vector<ChangedRow> changedRows(const MapChanges& changes,
                                                  const std::optional<Pose>& robotInMap);
/// Returns the summary: "monday → tuesday: new 3, gone 2". Empty when @p changes is null (not known yet), or
/// when nothing was compared.
[[nodiscard]] QString changedText(const MapChanges* changes);
/// Returns why the list is empty.
[[nodiscard]] QString unchangedText(const MapChanges* changes);

/// What is new or has disappeared, as a table. The selection stays at its row number as long as the number of
/// rows does not change. rowAt() finds a thing again by its place.
class ChangedModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Number, What, Size, Where, Place };

    using TextRowsModel::TextRowsModel;

    void setRows(const std::vector<ChangedRow>& rows);
    [[nodiscard]] const ChangedRow* row(int row) const;  ///< null: there is none
    /// Returns the row nearest to @p place within @p reach [m]; -1: there is none.
    [[nodiscard]] int rowAt(const Eigen::Vector3d& place, double reach) const;

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;

private:
    std::vector<ChangedRow> m_rows;
};

}  // namespace leitstand
