#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/robot/robot_description.h"
#include "widgets/models/text_rows_model.h"

namespace leitstand {

struct RobotState;

/// A number that a robot reports, as a row of the pane.
struct ReadingRow {
    std::string topic;      ///< of its stream
    std::size_t index = 0;  ///< in StreamDescription::readings
    QString title, value, limits;
    QString age;  ///< how old it is, if it is not of now; empty: it is of now, or none came
    QString hint;
    Tone tone = Tone::Normal;  ///< of the value
    friend bool operator==(const ReadingRow&, const ReadingRow&) = default;
};

/// Returns what @p robot has reported until @p now (station's clock), in the order of its file.
[[nodiscard]] std::vector<ReadingRow> readingRows(const RobotDescription& robot, const RobotState& reported,
                                                  Time now);

/// Readings as rows of a table.
class ReadingRowsModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Title, Value, Limits, Age, Columns };
    using TextRowsModel::TextRowsModel;

    void show(const std::vector<ReadingRow>& rows);
    [[nodiscard]] const std::vector<ReadingRow>& rows() const { return m_rows; }

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;
    [[nodiscard]] Tone tone(int row, int column) const override;

private:
    std::vector<ReadingRow> m_rows;
};

}  // namespace leitstand
