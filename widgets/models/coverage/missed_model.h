#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/base/pose.h"
#include "core/mission/coverage/searched_floor.h"
#include "widgets/models/text_rows_model.h"

namespace leitstand {

/// A piece of floor that was missed, as a row of a list.
struct MissedRow {
    int number = 0;                                   ///< from 1; the largest piece has 1
    QString area;                                     ///< "4.2 m²"
    QString where;                                    ///< from the robot: "3.2 m, 40° left"
    QString place;                                    ///< "x 1.2, y −0.5"
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< a point of the piece [m]
    friend bool operator==(const MissedRow&, const MissedRow&) = default;
};

/// Returns the pieces that @p sensor missed, the largest first. @p robotInMap: pose of the selected robot;
/// empty: unknown.
[[nodiscard]] std::vector<MissedRow> missedRows(const SearchedFloor& searched, SearchSensor sensor,
                                                const std::optional<Pose>& robotInMap);
/// Returns why the list of what was missed is empty. @p searched: null until it is known.
[[nodiscard]] QString emptyText(const SearchedFloor* searched, SearchSensor sensor);
/// "Camera: 61 % of 20.1 m² seen, places missed: 3".
[[nodiscard]] QString searchedText(const SearchedFloor& searched, SearchSensor sensor);

/// Pieces of floor that were missed, as a table. The selection stays at its row number as long as the number
/// of rows does not change. rowAt() finds a piece again by its place.
class MissedModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Number, Area, Where, Place };

    using TextRowsModel::TextRowsModel;

    void setRows(const std::vector<MissedRow>& rows);
    [[nodiscard]] const MissedRow* row(int row) const;  ///< null: there is none
    /// Returns the row nearest to @p place within @p reach [m]; -1: there is none.
    [[nodiscard]] int rowAt(const Eigen::Vector3d& place, double reach) const;

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;

private:
    std::vector<MissedRow> m_rows;
};

}  // namespace leitstand
