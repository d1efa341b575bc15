#pragma once

#include <optional>
#include <vector>

#include <QFrame>

#include "core/mapping/storeys.h"

class QToolButton;
class QVBoxLayout;

namespace leitstand {

/// A button for each storey of the map, the highest at the top, and one for all storeys. Hidden if the map
/// has only one storey.
class StoreyRow final : public QFrame {
    Q_OBJECT
public:
    explicit StoreyRow(QWidget* parent);

    void setStoreys(const std::vector<Storey>& storeys);
    /// Checks the button of the storey @p number, or if @p all is true, that of all storeys. If neither is
    /// given, the heights that are shown belong to no storey.
    void setChosen(std::optional<int> number, bool all);

signals:
    void wanted(std::optional<int> number);

private:
    struct Button {
        std::optional<int> number;
        QToolButton* button;
    };
    void add(std::optional<int> number, const QString& text, const QString& name);

    QVBoxLayout* m_layout;
    std::vector<Button> m_buttons;  ///< from top to bottom
    std::optional<int> m_chosen;
    bool m_all = true;
};

}  // namespace leitstand
