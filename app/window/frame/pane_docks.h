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
/// arranges panes (setArranging()), docks have titles by which they can be dragged, and may float. At other
/// times the mouse cannot move them by accident.
class PaneDocks final : public QMainWindow {
    Q_OBJECT
public:
    explicit PaneDocks(QWidget* parent = nullptr);

    /// Adds @p pane, which is hidden until a layout names it. @p title: for people. @p formerId: the pane's
    /// id in older layouts and saved arrangements; empty: the same.
    void add(const QString& id, const QString& title, QWidget& pane, const QString& formerId = {});
    /// Keeps the pane @p id visible: no other pane opens as a tab over it as long as there is another host.
    /// Sheets have their own hosts.
    void keepInSight(const QString& id) { m_inSight.insert(id); }
    /// Makes the pane @p id a sheet, which opens with at least its sizeHint(). If the layout has no place for
    /// it, it shares the space of the first visible pane in @p hosts, beside that pane. If this is too small
    /// for both, it covers the host as a tab. Without a visible host it opens beside the widest visible pane,
    /// never as a tab.
    void addSheet(const QString& id, const QStringList& hosts);
    [[nodiscard]] QStringList ids() const;
    [[nodiscard]] bool has(const QString& id) const {
        return dock(id) != nullptr;
    }  ///< @p id may be a former id
    [[nodiscard]] bool isPaneVisible(const QString& id) const;
    /// Returns the action that shows or hides the pane @p id; it is checked while the pane is shown. Null:
    /// there is no such pane. A pane without a place in the layout opens as a tab over the smallest pane that
    /// is large enough.
    [[nodiscard]] QAction* visibility(const QString& id) const;
    /// Shows a pane in front of others at the same place.
    void open(const QString& id);
    /// Hides the pane @p id, unless the layout has a place for it, or it floats.
    void putAway(const QString& id);

    /// Places panes as @p layout describes. Panes that it does not name are hidden. If a named pane does not
    /// exist, its neighbours get its space.
    void arrange(const WindowLayout& layout);
    /// Returns the present arrangement, for WindowLayout::arrangement.
    [[nodiscard]] std::string arrangement() const;
    /// Swaps the places of two panes. Does nothing when one does not exist.
    void swap(const QString& one, const QString& other);

    void setArranging(bool on);
    [[nodiscard]] bool isArranging() const { return m_arranging; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QString idOf(const QString& name) const;  ///< @p name, or the id that has replaced it
    [[nodiscard]] QDockWidget* dock(const QString& id) const;
    [[nodiscard]] PaneSplit known(const PaneSplit& split) const;
    void place(const PaneSplit& split);
    void giveRoom(const PaneSplit& split, QSize room);
    void fit();
    void open(QDockWidget& dock);
    void settle(QDockWidget& sheet);
    [[nodiscard]] QDockWidget* sheetHost(const QDockWidget& sheet, const QStringList& hosts) const;
    /// Returns the sheet that is open beside the pane @p id, or if @p beside is false, as a tab over it.
    /// Null: there is none.
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
    std::map<QString, Stay> m_stays;          ///< where each sheet is while it is open
    std::set<QDockWidget*> m_strays;  ///< docks whose place comes from neither a layout nor the operator
    PaneSplit m_placed;   ///< present layout, kept on resizing; empty: the operator arranged the panes
    QByteArray m_unseen;  ///< arrangement that was selected before the window had its size
    bool m_arranging = false;
};

}  // namespace leitstand
