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

/// Victims, other finds and candidates, with the commands that a window offers for them: where robots drive,
/// what is known of each, how far and where from the robot; in a review, when they were found, and what was
/// discarded.
class VictimsPanel final : public QWidget {
    Q_OBJECT
public:
    enum class Use { Live, Review };
    explicit VictimsPanel(QWidget* parent = nullptr, Use use = Use::Live);

    void show(const std::vector<VictimRow>& rows);
    using QWidget::show;
    /// Buttons for these commands, too, below the list.
    void addCommands(const std::vector<QAction*>& commands);
    /// The row that is chosen; empty: none.
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
