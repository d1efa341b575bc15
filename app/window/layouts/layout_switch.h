#pragma once

#include <vector>

#include <QWidget>

class QAction;
class QHBoxLayout;
class QMenu;
class QToolButton;

namespace leitstand {

/// Chooses one of several actions: all of them side by side, or one button with a menu when there is not room
/// for that. Its sizes depend on the actions alone, not on which is checked.
class LayoutSwitch final : public QWidget {
    Q_OBJECT
public:
    explicit LayoutSwitch(QWidget* parent = nullptr);

    void clear();
    /// Adds @p choice. @p name: object name of its button.
    void add(QAction& choice, const QString& name);
    [[nodiscard]] bool isFolded() const;

    [[nodiscard]] QSize sizeHint() const override;         ///< of all side by side
    [[nodiscard]] QSize minimumSizeHint() const override;  ///< of the one button with a menu

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fold();
    void showChecked();
    /// Returns the width of the one button when it shows @p choice [px].
    [[nodiscard]] int foldedWidth(const QAction& choice) const;

    QWidget* m_row;
    QHBoxLayout* m_line;
    QToolButton* m_button;
    QMenu* m_menu;
    std::vector<QAction*> m_choices;
};

}  // namespace leitstand
