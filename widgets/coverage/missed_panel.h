#pragma once

#include <optional>

#include <QWidget>

#include "widgets/models/coverage/missed_model.h"

class QComboBox;
class QLayout;
class QLabel;
class QTableView;
class QAction;

namespace leitstand {

/// Lists reachable floor that a kind of sensor has not seen, largest piece first.
class MissedPanel final : public QWidget {
    Q_OBJECT
public:
    explicit MissedPanel(QWidget* parent = nullptr);

    /// Shows @p searched; null: there is no map yet. @p robotInMap: pose of the selected robot.
    void show(const SearchedFloorPtr& searched, const std::optional<Pose>& robotInMap);
    using QWidget::show;
    [[nodiscard]] SearchSensor sensor() const;
    void setSensor(SearchSensor sensor);
    /// Adds a button below the list for each of @p commands.
    void setCommands(const std::vector<QAction*>& commands);
    /// Returns the chosen piece; empty: none.
    [[nodiscard]] std::optional<MissedRow> chosen() const;
    /// Chooses the largest piece when none is chosen.
    void chooseFirst();

    [[nodiscard]] QSize sizeHint() const override { return {320, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 90}; }

signals:
    void sensorChosen(leitstand::SearchSensor sensor);
    void chosenChanged();
    void activated();  ///< double click or Return on a row

protected:
    void focusInEvent(QFocusEvent* event) override;

private:
    MissedModel m_model;
    QComboBox* m_sensor;
    QLabel *m_title, *m_calm;
    QTableView* m_table;
    QLayout* m_buttons;
};

}  // namespace leitstand
