#pragma once

#include <utility>
#include <vector>

#include <QWidget>

namespace leitstand {

/// A number over the time before now, with its least, greatest and newest value.
class TrendPlot final : public QWidget {
    Q_OBJECT
public:
    explicit TrendPlot(QWidget* parent = nullptr);

    /// @p title: what it is. @p points: ages [s] and numbers, oldest first. @p span: width of the plot [s].
    void show(const QString& title, std::vector<std::pair<double, double>> points, double span);
    using QWidget::show;

    [[nodiscard]] QSize sizeHint() const override { return {260, 90}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {120, 60}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_title;
    std::vector<std::pair<double, double>> m_points;
    double m_span = 60.0;
};

}  // namespace leitstand
