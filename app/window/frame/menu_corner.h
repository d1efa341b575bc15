#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QMenuBar;

namespace leitstand {

class ElidedLabel;

/// Fills the room beside the menus: the newest message, which gives way, and right of it badges, which do
/// not. No message moves the menus.
class MenuCorner final : public QWidget {
    Q_OBJECT
public:
    /// @p menus must have all its menus and no corner widget.
    explicit MenuCorner(QMenuBar& menus);

    void setMessage(const QString& text, const QString& toolTip);
    /// Adds @p badge right of earlier ones. A hidden badge keeps its place when @p keepsPlace.
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
