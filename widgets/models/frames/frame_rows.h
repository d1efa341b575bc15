#pragma once

#include <vector>

#include <QString>

#include "core/base/time.h"
#include "core/station/frames/frame_tree.h"
#include "widgets/models/text_rows_model.h"

namespace leitstand {

/// A frame of a robot's tf tree, in words.
struct FrameLine {
    QString frame;  ///< with blanks before it, two for each frame above
    QString place;  ///< x, y and z in its parent [m]; empty for a root
    QString rate;   ///< "50 Hz", "static"
    QString age;    ///< of its newest transform; empty if it is static or young
    QString hint;   ///< parent, place, rotation, topic, and what is wrong with it
    Tone tone = Tone::Normal;
    friend bool operator==(const FrameLine&, const FrameLine&) = default;
};

/// Returns @p rows in words.
[[nodiscard]] std::vector<FrameLine> frameLines(const std::vector<FrameRow>& rows, Time now);
/// Returns what stands above the table: how many frames there are, what is wrong with them, and the frames
/// @p unconnected of sensors to which no transforms lead. @p attention: whether something is wrong.
[[nodiscard]] QString framesSummary(const std::vector<FrameRow>& rows,
                                    const std::vector<std::string>& unconnected, bool& attention);

/// Frames as rows of a table.
class FrameRowsModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Frame, Place, Rate, Age, Columns };
    using TextRowsModel::TextRowsModel;

    void show(const std::vector<FrameLine>& lines);
    [[nodiscard]] const std::vector<FrameLine>& lines() const { return m_lines; }

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_lines.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;
    [[nodiscard]] Tone tone(int row, int column) const override;

private:
    std::vector<FrameLine> m_lines;
};

}  // namespace leitstand
