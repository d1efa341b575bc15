#pragma once

#include <vector>

#include <QWidget>

class QAction;
class QHBoxLayout;
class QMenu;
class QToolButton;

namespace leitstand {

/// Chooses one of several actions, of which one is checked: all of them side by side, or where there is not
/// room for that one button with a menu. Its sizes depend on the actions alone, not on which is checked.
class LayoutSwitch final : public QWidget {
    Q_OBJECT
public:
    explicit LayoutSwitch(QWidget* parent = nullptr);

    void clear();
    /// @p name: object name of its button.
    void add(QAction& choice, const QString& name);
    [[nodiscard]] bool isFolded() const;

    [[nodiscard]] QSize sizeHint() const override;         ///< of all side by side
    [[nodiscard]] QSize minimumSizeHint() const override;  ///< of the one button

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fold();
    void showChecked();
    /// The width of the one button with the name of @p choice.
    [[nodiscard]] int foldedWidth(const QAction& choice) const;

    QWidget* m_row;
    QHBoxLayout* m_line;
    QToolButton* m_button;
    QMenu* m_menu;
    std::vector<QAction*> m_choices;
};

}  // namespace leitstand
