#pragma once

#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "app/window/frame/folding_row.h"

class QLabel;
class QMainWindow;
class QWidget;

namespace leitstand {

class MenuCorner;

/// The frame around the panes of live windows and reviews: a bar above them, and beside the menus the newest
/// message and badges.
class WindowFrame final : public QObject {
    Q_OBJECT
public:
    /// One part of the bar.
    struct Part {
        QWidget* widget = nullptr;
        GivesWay gives = GivesWay::Never;
    };

    explicit WindowFrame(QMainWindow& window);

    /// Stacks a bar with @p left and @p right at its ends, then @p panes, then @p below. Hides menus without
    /// entries.
    void build(const std::vector<Part>& left, const std::vector<Part>& right, QWidget& panes,
               QWidget* below = nullptr);
    /// Places @p badge beside the menus, to the right of earlier badges. Call build() first. @p keepsPlace:
    /// its place stays free while it is hidden, so that earlier badges do not move.
    void addBadge(QLabel& badge, bool keepsPlace = false);
    /// Shows @p text as the newest message. The tooltip also lists earlier messages.
    void showMessage(const QString& text);
    [[nodiscard]] QString newest() const;
    [[nodiscard]] const QStringList& recent() const { return m_recent; }  ///< newest first

private:
    void showMessage();

    QMainWindow& m_window;
    MenuCorner* m_corner = nullptr;  ///< null before build()
    QStringList m_recent;
};

}  // namespace leitstand
