#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QWidget>

#include "widgets/models/live/readings/reading_rows.h"

class QLabel;
class QTableView;

namespace leitstand {

class TrendPlot;

/// What a robot's further sensors say: temperatures, distances, any number of any topic, with their limits. A
/// plot shows the last two minutes of the one that is chosen.
class ReadingsPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ReadingsPanel(QWidget* parent = nullptr);

    /// Empty: says that the robot has none.
    void showReadings(const std::vector<ReadingRow>& rows);
    /// @p points: ages [s] and numbers of chosen(), oldest first. @p span: width of the plot [s].
    void showPlot(const std::vector<std::pair<double, double>>& points, double span);
    /// The reading that is plotted; empty: there is none.
    [[nodiscard]] std::optional<ReadingRow> chosen() const;

    [[nodiscard]] QSize sizeHint() const override { return {300, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {150, 90}; }

signals:
    void readingChosen();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    ReadingRowsModel m_rows;
    QTableView* m_table;
    QLabel* m_none;
    TrendPlot* m_plot;
};

}  // namespace leitstand
