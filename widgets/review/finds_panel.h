#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/review/find_rows.h"

class QLabel;
class QToolButton;
class QTreeWidget;

namespace leitstand {

/// The finds of a reviewed mission, to be jumped to and corrected; and the notes' button.
class FindsPanel final : public QWidget {
    Q_OBJECT
public:
    explicit FindsPanel(QWidget* parent = nullptr);

    void show(std::vector<FindRow> rows);
    using QWidget::show;
    void setUndoable(bool on);
    [[nodiscard]] std::optional<FindKey> chosen() const;
    void choose(const FindKey& find);

    [[nodiscard]] QSize sizeHint() const override { return {340, 160}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 90}; }

signals:
    void sought(leitstand::Time at);  ///< to when a find was found
    void confirmed(const leitstand::FindKey& find);
    void discarded(const leitstand::FindKey& find);
    void formWanted(const leitstand::FindKey& find);
    void noteWanted();
    void undone();

private:
    [[nodiscard]] QToolButton* button(const char* name, const QString& text, const QString& hint);
    void refresh();

    std::vector<FindRow> m_rows;
    QTreeWidget* m_list;
    QLabel *m_title, *m_calm;
    QToolButton *m_confirm, *m_discard, *m_edit, *m_undo;
};

}  // namespace leitstand
