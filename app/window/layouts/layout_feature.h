#pragma once

#include <map>
#include <string>

#include <QObject>
#include <QString>

#include "app/services/layouts/layout_book.h"
#include "app/services/layouts/layout_sights.h"
#include "app/window/panes/view_context.h"

class QAction;
class QActionGroup;

namespace leitstand {

class LayoutSwitch;
class MapFeature;

/// Arranges the panes of a live window or a review. Layouts are switched by key, by menu and by the switch in
/// the top bar. The operator's own layouts are files. Camera and map can be swapped. Each layout has its own
/// view of the map.
class LayoutFeature final : public QObject {
    Q_OBJECT
public:
    LayoutFeature(const ViewContext& context, LayoutBook book, MapFeature& map);

    /// The switch for the top bar.
    [[nodiscard]] LayoutSwitch* bar() const { return m_bar; }
    [[nodiscard]] const WindowLayout& current() const { return m_used; }
    /// Switches to the layout @p name. Shows a message and returns false when there is none.
    bool use(const QString& name);
    /// As use(), for the first layout of a window. Layouts used earlier in the window then do not affect the
    /// view of the map.
    bool begin(const QString& name);
    /// Returns the operator's own view of the map, which is used if a layout defines none.
    [[nodiscard]] MapSight ownSight() const;
    /// Saves the present arrangement of panes and view of the map as a layout with @p title, and switches to
    /// it. Keys and pad buttons are those of the present layout. Shows a message and returns false when it
    /// cannot be saved.
    bool saveAs(const QString& title);

signals:
    /// Another layout is used now. @p bindings: ids of commands by pad button.
    void padBound(const std::map<std::string, std::string>& bindings);

private:
    void addCommands();
    void addPanes();  ///< adds a list of panes to the View menu, which is filled each time it is opened
    void fill();      ///< fills menu and switch with the layouts of the book
    /// Returns whether this window has most of the panes in @p layout.
    [[nodiscard]] bool isOfUse(const WindowLayout& layout) const;
    void addChoice(const WindowLayout& layout, int place);
    void askForTitle();
    /// Returns the file name for a layout called @p title: that of the operator's own layout with this title;
    /// if there is none, a new name.
    [[nodiscard]] std::string nameFor(const QString& title) const;
    void forget();

    ViewContext m_context;
    LayoutBook m_book;
    MapFeature& m_map;
    LayoutSights m_sights;
    LayoutSwitch* m_bar;
    QActionGroup* m_choices;
    QAction* m_forget = nullptr;
    WindowLayout m_used;
};

}  // namespace leitstand
