#pragma once

#include <QLabel>

namespace leitstand {

/// Text that gives way: what does not fit into a line, or into so many small ones as it may have, ends in
/// dots.
class ElidedLabel final : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// How many lines a text may take that is too long for one, where there is room.
    void setMostLines(int lines) { m_mostLines = lines; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_mostLines = 1;
};

}  // namespace leitstand
