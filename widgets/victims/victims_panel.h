#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/victims/victim_list_model.h"

class QAction;
class QLayout;
class QLabel;
class QTableView;

namespace leitstand {

/// Lists victims, other finds and candidates, with the window's commands for them. With live robots, it shows
/// what is known about each, and its distance and direction from the robot. In a review, it shows when each
/// was found, and what was discarded.
class VictimsPanel final : public QWidget {
    Q_OBJECT
public:
    enum class Use { Live, Review };
    explicit VictimsPanel(QWidget* parent = nullptr, Use use = Use::Live);

    void show(const std::vector<VictimRow>& rows);
    using QWidget::show;
    /// Adds a button below the list for each of @p commands.
    void addCommands(const std::vector<QAction*>& commands);
    /// Returns the selected row; empty: none.
    [[nodiscard]] std::optional<VictimRow> chosen() const;
    bool choose(const FindKey& find);  ///< false: it is not in the list

    [[nodiscard]] QSize sizeHint() const override { return {360, 180}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {198, 90}; }

signals:
    void chosenChanged();
    void activated();  ///< double click or Return on a row

private:
    VictimListModel m_model;
    QLabel *m_title, *m_calm;
    QTableView* m_table;
    QLayout* m_buttons;
};

}  // namespace leitstand
