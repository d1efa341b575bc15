#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/frames/frame_rows.h"

class QLabel;
class QTableView;

namespace leitstand {

/// The tf tree of a robot: its frames, where each lies in its parent, and how old that is.
class FramesPanel final : public QWidget {
    Q_OBJECT
public:
    explicit FramesPanel(QWidget* parent = nullptr);

    /// @p attention: whether @p summary tells of something that is wrong.
    void showFrames(const std::vector<FrameLine>& lines, const QString& summary, bool attention);

    [[nodiscard]] QSize sizeHint() const override { return {380, 320}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 120}; }

private:
    FrameRowsModel m_rows;
    QLabel* m_summary;
    QTableView* m_table;
};

}  // namespace leitstand
