#pragma once

#include <map>
#include <set>
#include <vector>

#include <QByteArray>
#include <QList>
#include <QMainWindow>
#include <QString>
#include <QStringList>

#include "core/settings/window_layout.h"

class QAction;
class QDockWidget;

namespace leitstand {

/// The panes of the live window, each in a dock that layouts place by the pane's id. While they are being
/// arranged they have titles to be dragged by, and may float; otherwise nothing moves by a slip of the mouse.
class PaneDocks final : public QMainWindow {
    Q_OBJECT
public:
    explicit PaneDocks(QWidget* parent = nullptr);

    /// Takes @p pane over; hidden until a layout names it. @p title: for people. @p formerId: what layouts
    /// and saved arrangements called it before; empty: the same.
    void add(const QString& id, const QString& title, QWidget& pane, const QString& formerId = {});
    /// Others are not opened as a tab before pane @p id, while there is another that they may.
    void keepInSight(const QString& id) { m_inSight.insert(id); }
    /// Pane @p id is a sheet, of its sizeHint() at least. Where the layout has no place for it, it opens
    /// beside the first of @p hosts that is in sight, in that one's room, or as a tab before it where the
    /// room is too small for both; never before another pane.
    void addSheet(const QString& id, const QStringList& hosts);
    [[nodiscard]] QStringList ids() const;
    [[nodiscard]] bool has(const QString& id) const {
        return dock(id) != nullptr;
    }  ///< also by its former id
    [[nodiscard]] bool isPaneVisible(const QString& id) const;
    /// Shows or hides one pane; while it is checked it is shown. One that the layout has no place for comes
    /// as a tab before the smallest pane with room for it.
    [[nodiscard]] QAction* visibility(const QString& id) const;
    /// Shows a pane, before others that share its room.
    void open(const QString& id);
    /// Hides a pane that the layout has no place for.
    void putAway(const QString& id);

    /// Places panes as @p layout says; those that it does not name are hidden, those that it names but are
    /// not here leave their room to their neighbours.
    void arrange(const WindowLayout& layout);
    /// How they are now, for WindowLayout::arrangement.
    [[nodiscard]] std::string arrangement() const;
    /// Two panes change places; nothing when one is not here.
    void swap(const QString& one, const QString& other);

    void setArranging(bool on);
    [[nodiscard]] bool isArranging() const { return m_arranging; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QString idOf(const QString& name) const;  ///< of today, where @p name is a former one
    [[nodiscard]] QDockWidget* dock(const QString& id) const;
    [[nodiscard]] PaneSplit known(const PaneSplit& split) const;
    void place(const PaneSplit& split);
    void giveRoom(const PaneSplit& split, QSize room);
    void fit();
    void open(QDockWidget& dock);
    void settle(QDockWidget& sheet);
    [[nodiscard]] QDockWidget* sheetHost(const QDockWidget& sheet, const QStringList& hosts) const;
    /// The sheet that is open at pane @p id, @p beside it or before it; null: none is.
    [[nodiscard]] QDockWidget* guestOf(const std::string& id, bool beside) const;
    [[nodiscard]] QSize needOf(const PaneSplit& split) const;
    [[nodiscard]] QList<int> sizesIn(const PaneSplit& split, QSize room) const;
    [[nodiscard]] QAction* toggleOf(QDockWidget& dock);
    [[nodiscard]] QDockWidget* hostOf(const QDockWidget& dock) const;
    static void dress(QDockWidget& dock, bool withTitle);

    std::vector<QString> m_ids;
    std::map<QString, QDockWidget*> m_docks;
    std::map<QString, QString> m_former;  ///< ids by former ones
    std::map<const QDockWidget*, QAction*> m_toggles;
    struct Stay {
        QString host;
        bool beside = false;
    };
    std::set<QString> m_inSight;
    std::map<QString, QStringList> m_sheets;  ///< where each may be
    std::map<QString, Stay> m_stays;          ///< where each is while it is open
    std::set<QDockWidget*> m_strays;          ///< that the layout has no place for and nobody gave one
    PaneSplit m_placed;   ///< shares hold when the window changes its size, until a pane was moved
    QByteArray m_unseen;  ///< arrangement that was chosen before the window had its size
    bool m_arranging = false;
};

}  // namespace leitstand
