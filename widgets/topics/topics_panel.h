#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QWidget>

#include "widgets/models/topics/topic_rows.h"

class QLabel;
class QLineEdit;
class QSplitter;
class QTableView;

namespace leitstand {

class TrendPlot;

/// All topics of the domain, and what comes on the one that is chosen: how often, its newest message field by
/// field, and a plot of one of its numbers.
class TopicsPanel final : public QWidget {
    Q_OBJECT
public:
    explicit TopicsPanel(QWidget* parent = nullptr);

    void showTopics(const std::vector<TopicRow>& rows);
    /// @p summary: how often and when it came, or why nothing can be shown.
    void showMessage(const QString& summary, const std::vector<FieldRow>& fields);
    void showPlot(const std::vector<std::pair<double, double>>& points, double span);
    [[nodiscard]] const QString& chosen() const { return m_chosen; }    ///< topic; empty: none
    [[nodiscard]] const QString& plotted() const { return m_plotted; }  ///< path of its field; empty: none

    [[nodiscard]] QSize sizeHint() const override { return {520, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {240, 160}; }

signals:
    void topicChosen(const QString& topic);
    void fieldChosen(const QString& path);
    void shownChanged(bool shown);  ///< whether anybody can see the panel

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    void fit();  ///< lists side by side where the pane is low, and no plot where it is lower still

    std::vector<TopicRow> m_rows;
    TopicRowsModel m_topics;
    FieldRowsModel m_fields;
    QLineEdit* m_filter;
    QTableView *m_topicTable, *m_fieldTable;
    QLabel* m_summary;
    TrendPlot* m_plot;
    QSplitter* m_halves;
    QString m_chosen, m_plotted;
};

}  // namespace leitstand
