#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QMenuBar;

namespace leitstand {

class ElidedLabel;

/// Fills the space beside the menus with the newest message and, to its right, badges. The message shrinks to
/// leave space for badges; nothing moves the menus.
class MenuCorner final : public QWidget {
    Q_OBJECT
public:
    /// @p menus must already have all menus, and no corner widget.
    explicit MenuCorner(QMenuBar& menus);

    void setMessage(const QString& text, const QString& toolTip);
    /// Adds @p badge to the right of earlier badges. @p keepsPlace: its place stays free while it is hidden.
    void addBadge(QLabel& badge, bool keepsPlace);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QMenuBar& m_menus;
    const QSize m_taken;  ///< size of the menus when the space was last computed
    QHBoxLayout* m_row;
    ElidedLabel* m_message;
    int m_width = 0;
};

}  // namespace leitstand
