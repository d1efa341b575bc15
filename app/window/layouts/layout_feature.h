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

/// Arranges the live window: layouts by key, menu and the switch in the top bar, the operator's own layouts
/// as files, and swapping camera and map. Each layout has its own way to look at the map.
class LayoutFeature final : public QObject {
    Q_OBJECT
public:
    LayoutFeature(const ViewContext& context, LayoutBook book, MapFeature& map);

    /// The switch for the top bar.
    [[nodiscard]] LayoutSwitch* bar() const { return m_bar; }
    [[nodiscard]] const WindowLayout& current() const { return m_used; }
    /// Switches to layout @p name. Shows a message and returns false when there is none.
    bool use(const QString& name);
    /// Like use(), for the first layout of a window: no earlier one determines how the map is looked at.
    bool begin(const QString& name);
    /// Returns how the operator looks at the map where layouts leave it open.
    [[nodiscard]] MapSight ownSight() const;
    /// Saves the present arrangement and map under @p title, with the keys of the layout in use. Shows a
    /// message and returns false when they cannot be saved.
    bool saveAs(const QString& title);

signals:
    /// A layout came into use. @p bindings: ids of commands by pad button.
    void padBound(const std::map<std::string, std::string>& bindings);

private:
    void addCommands();
    void addPanes();  ///< to the View menu, each time it is opened
    void fill();      ///< fills menu and switch with the layouts of the book
    /// Returns whether this window has most of the panes that @p layout names.
    [[nodiscard]] bool isOfUse(const WindowLayout& layout) const;
    void addChoice(const WindowLayout& layout, int place);
    void askForTitle();
    /// Returns a file name for a layout titled @p title. Returns the name of the operator's own layout with
    /// that title, when there is one.
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
