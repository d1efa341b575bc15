#pragma once

#include <QWidget>

namespace leitstand {

class NumberBox;
class ViewState;

/// Edits the numbers of the present look: the edge of the voxels [cm], or the two heights of a clipped map
/// [m]. Hidden if the look has neither.
class LookBar final : public QWidget {
    Q_OBJECT
public:
    /// Shows and edits @p state, which must outlive this object.
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
