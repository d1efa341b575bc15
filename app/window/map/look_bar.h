#pragma once

#include <QWidget>

namespace leitstand {

class NumberBox;
class ViewState;

/// Edits the numbers of the present look: edge of the voxels, and the two heights of a clipped map. Hidden
/// when there are none.
class LookBar final : public QWidget {
    Q_OBJECT
public:
    /// Shows and edits @p state, which must outlive it.
    explicit LookBar(ViewState& state, QWidget* parent = nullptr);

private:
    [[nodiscard]] QWidget* voxelGroup();
    [[nodiscard]] QWidget* clipGroup();
    void showState();

    ViewState& m_state;
    NumberBox* m_edge;
    NumberBox* m_low;
    NumberBox* m_high;
    QWidget* m_voxels;
    QWidget* m_clip;
};

}  // namespace leitstand
