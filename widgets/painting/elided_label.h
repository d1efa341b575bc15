#pragma once

#include <QLabel>

namespace leitstand {

/// A label that can shrink. Text that does not fit on one line, or on the allowed number of small lines, is
/// elided.
class ElidedLabel final : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    [[nodiscard]] QSize minimumSizeHint() const override;
    /// Sets the largest number of small lines for a text that does not fit on one line. A low label shows
    /// fewer.
    void setMostLines(int lines) { m_mostLines = lines; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_mostLines = 1;
};

}  // namespace leitstand
