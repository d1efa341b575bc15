#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QMenuBar;

namespace leitstand {

class ElidedLabel;

/// Fills the room beside the menus with the newest message and, right of it, badges. The message gives way to
/// badges; nothing moves the menus.
class MenuCorner final : public QWidget {
    Q_OBJECT
public:
    /// @p menus must have all menus already, and no corner widget.
    explicit MenuCorner(QMenuBar& menus);

    void setMessage(const QString& text, const QString& toolTip);
    /// Adds @p badge right of earlier badges. @p keepsPlace: its place stays free while it is hidden.
    void addBadge(QLabel& badge, bool keepsPlace);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QMenuBar& m_menus;
    const QSize m_taken;  ///< size of the menus
    QHBoxLayout* m_row;
    ElidedLabel* m_message;
    int m_width = 0;
};

}  // namespace leitstand
