#pragma once

#include <vector>

#include <QWidget>

class QAction;
class QHBoxLayout;
class QMenu;
class QToolButton;

namespace leitstand {

/// Selects one of several actions: all of them side by side, or if there is not enough space, one button with
/// a menu. Its sizes depend only on the actions, not on which is checked.
class LayoutSwitch final : public QWidget {
    Q_OBJECT
public:
    explicit LayoutSwitch(QWidget* parent = nullptr);

    void clear();
    /// Adds @p choice. @p name: object name of its button.
    void add(QAction& choice, const QString& name);
    [[nodiscard]] bool isFolded() const;

    [[nodiscard]] QSize sizeHint() const override;         ///< with all actions side by side
    [[nodiscard]] QSize minimumSizeHint() const override;  ///< with one button that has a menu

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fold();
    void showChecked();
    /// Returns the width of the single button when it shows @p choice [px].
    [[nodiscard]] int foldedWidth(const QAction& choice) const;

    QWidget* m_row;
    QHBoxLayout* m_line;
    QToolButton* m_button;
    QMenu* m_menu;
    std::vector<QAction*> m_choices;
};

}  // namespace leitstand
