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

/// What windows on robots have around their panes, live ones and reviews: a bar above them, and beside the
/// menus the newest message and badges.
class WindowFrame final : public QObject {
    Q_OBJECT
public:
    /// One part of the bar.
    struct Part {
        QWidget* widget = nullptr;
        GivesWay gives = GivesWay::Never;
    };

    explicit WindowFrame(QMainWindow& window);

    /// Stacks a bar, which has @p left and @p right at its ends, @p panes and @p below. Menus without entries
    /// are not shown.
    void build(const std::vector<Part>& left, const std::vector<Part>& right, QWidget& panes,
               QWidget* below = nullptr);
    /// Once it is built: @p badge stands in the corner beside the menus, right of those before it. A hidden
    /// one keeps its place when @p keepsPlace, so that none before it moves.
    void addBadge(QLabel& badge, bool keepsPlace = false);
    /// Shows @p text as the newest message; its tooltip has those before it too.
    void showMessage(const QString& text);
    [[nodiscard]] QString newest() const;
    [[nodiscard]] const QStringList& recent() const { return m_recent; }  ///< the newest first

private:
    void showMessage();

    QMainWindow& m_window;
    MenuCorner* m_corner = nullptr;  ///< null until it is built
    QStringList m_recent;
};

}  // namespace leitstand
