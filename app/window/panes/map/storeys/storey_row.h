#pragma once

#include <optional>
#include <vector>

#include <QFrame>

#include "core/mapping/storeys.h"

class QToolButton;
class QVBoxLayout;

namespace leitstand {

/// A button for each storey of the map, the highest on top, and one for all of them. Hidden when the map has
/// one storey only.
class StoreyRow final : public QFrame {
    Q_OBJECT
public:
    explicit StoreyRow(QWidget* parent);

    void setStoreys(const std::vector<Storey>& storeys);
    /// Checks the button of storey @p number or, with @p all, that of all storeys. Neither: the heights shown
    /// are no storey's.
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
