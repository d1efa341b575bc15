#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/changes/changed_model.h"

class QAction;
class QLabel;
class QLayout;
class QTableView;

namespace leitstand {

/// Lists what is new and what has disappeared since the earlier missions, largest first.
class ChangesPanel final : public QWidget {
    Q_OBJECT
public:
    explicit ChangesPanel(QWidget* parent = nullptr);

    /// Shows @p changes; null: not known yet. @p robotInMap: pose of the selected robot.
    void show(const MapChanges* changes, const std::optional<Pose>& robotInMap);
    using QWidget::show;
    /// Adds a button below the list for each of @p commands.
    void setCommands(const std::vector<QAction*>& commands);
    /// Returns the chosen row; empty: none.
    [[nodiscard]] std::optional<ChangedRow> chosen() const;

    [[nodiscard]] QSize sizeHint() const override { return {320, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 90}; }

signals:
    void activated();  ///< double click or Return on a row

protected:
    void focusInEvent(QFocusEvent* event) override;

private:
    ChangedModel m_model;
    QLabel *m_title, *m_calm;
    QTableView* m_table;
    QLayout* m_buttons;
};

}  // namespace leitstand
