#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QMenuBar;

namespace leitstand {

class ElidedLabel;

/// Has the room beside the menus to itself, all of it: the newest message, which gives way, and right of it
/// badges, which do not. Menus stay where they are whatever is told.
class MenuCorner final : public QWidget {
    Q_OBJECT
public:
    /// @p menus has all its menus and no other corner.
    explicit MenuCorner(QMenuBar& menus);

    void setMessage(const QString& text, const QString& toolTip);
    /// Right of those before it; hidden ones keep their place when @p keepsPlace.
    void addBadge(QLabel& badge, bool keepsPlace);
    [[nodiscard]] QSize sizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QMenuBar& m_menus;
    const QSize m_taken;  ///< by the menus
    QHBoxLayout* m_row;
    ElidedLabel* m_message;
    int m_width = 0;
};

}  // namespace leitstand
