#pragma once

#include <QWidget>

#include "widgets/models/live/robots/measures.h"

namespace leitstand {

/// A robot from above and from its right side: its outline, its base frame and its sensors, to scale.
class MeasuresDrawing final : public QWidget {
    Q_OBJECT
public:
    explicit MeasuresDrawing(QWidget* parent = nullptr);

    /// @p chosen: name of the sensor that is drawn in the colour of what is selected; may be empty.
    void show(const Measures& measures, const std::string& chosen);
    using QWidget::show;

    [[nodiscard]] QSize sizeHint() const override { return {520, 240}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 160}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Measures m_measures;
    std::string m_chosen;
};

}  // namespace leitstand
