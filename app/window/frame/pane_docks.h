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

/// The panes of a window, each in a dock. Layouts place docks by the ids of their panes. While the operator
/// arranges panes (setArranging()), docks have titles to drag them by and may float. Otherwise a slip of the
/// mouse moves nothing.
class PaneDocks final : public QMainWindow {
    Q_OBJECT
public:
    explicit PaneDocks(QWidget* parent = nullptr);

    /// Takes @p pane over, hidden until a layout names it. @p title: for people. @p formerId: the pane's id
    /// in older layouts and saved arrangements; empty: the same.
    void add(const QString& id, const QString& title, QWidget& pane, const QString& formerId = {});
    /// Keeps pane @p id in sight: no pane opens as a tab over it while there is another host. Sheets have
    /// hosts of their own.
    void keepInSight(const QString& id) { m_inSight.insert(id); }
    /// Makes pane @p id a sheet, which opens with at least its sizeHint(). When the layout has no place for
    /// it, it opens beside the first visible pane of @p hosts, in the room of that host. It covers the host
    /// as a tab when the room is too small for both. Without a visible host it opens beside the widest
    /// visible pane, never as a tab.
    void addSheet(const QString& id, const QStringList& hosts);
    [[nodiscard]] QStringList ids() const;
    [[nodiscard]] bool has(const QString& id) const {
        return dock(id) != nullptr;
    }  ///< @p id may be a former one
    [[nodiscard]] bool isPaneVisible(const QString& id) const;
    /// Returns the action that shows or hides pane @p id, checked while the pane is shown. Null: there is no
    /// such pane. A pane without a place in the layout opens as a tab over the smallest pane with room for
    /// it.
    [[nodiscard]] QAction* visibility(const QString& id) const;
    /// Shows a pane in front of others that share its room.
    void open(const QString& id);
    /// Hides pane @p id, unless the layout has a place for it or it floats.
    void putAway(const QString& id);

    /// Places panes as @p layout describes. Panes that it does not name are hidden. Named panes that do not
    /// exist leave their room to their neighbours.
    void arrange(const WindowLayout& layout);
    /// Returns the present arrangement, for WindowLayout::arrangement.
    [[nodiscard]] std::string arrangement() const;
    /// Exchanges the places of two panes. Does nothing when one does not exist.
    void swap(const QString& one, const QString& other);

    void setArranging(bool on);
    [[nodiscard]] bool isArranging() const { return m_arranging; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QString idOf(const QString& name) const;  ///< @p name, or the id that replaced it
    [[nodiscard]] QDockWidget* dock(const QString& id) const;
    [[nodiscard]] PaneSplit known(const PaneSplit& split) const;
    void place(const PaneSplit& split);
    void giveRoom(const PaneSplit& split, QSize room);
    void fit();
    void open(QDockWidget& dock);
    void settle(QDockWidget& sheet);
    [[nodiscard]] QDockWidget* sheetHost(const QDockWidget& sheet, const QStringList& hosts) const;
    /// Returns the sheet that is open beside pane @p id or, without @p beside, as a tab over that pane. Null:
    /// there is none.
    [[nodiscard]] QDockWidget* guestOf(const std::string& id, bool beside) const;
    [[nodiscard]] QSize needOf(const PaneSplit& split) const;
    [[nodiscard]] QList<int> sizesIn(const PaneSplit& split, QSize room) const;
    [[nodiscard]] QAction* toggleOf(QDockWidget& dock);
    [[nodiscard]] QDockWidget* hostOf(const QDockWidget& dock) const;
    static void dress(QDockWidget& dock, bool withTitle);

    std::vector<QString> m_ids;
    std::map<QString, QDockWidget*> m_docks;
    std::map<QString, QString> m_former;  ///< present ids by former ids
    std::map<const QDockWidget*, QAction*> m_toggles;
    struct Stay {
        QString host;
        bool beside = false;
    };
    std::set<QString> m_inSight;
    std::map<QString, QStringList> m_sheets;  ///< hosts of each sheet
    std::map<QString, Stay> m_stays;          ///< place of each sheet while it is open
    std::set<QDockWidget*> m_strays;          ///< docks that neither layout nor operator gave a place
    PaneSplit m_placed;   ///< layout in use, kept on resizing; empty: the operator arranged the panes
    QByteArray m_unseen;  ///< arrangement chosen before the window had its size
    bool m_arranging = false;
};

}  // namespace leitstand
