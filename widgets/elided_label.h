#pragma once

#include <QLabel>

namespace leitstand {

/// One line of text that gives way: what does not fit ends in dots.
class ElidedLabel final : public QLabel {
    Q_OBJECT
public:
    using QLabel::QLabel;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace leitstand
