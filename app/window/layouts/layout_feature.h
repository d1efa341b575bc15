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

/// How the live window is arranged: layouts by key, menu and the switch in the top bar, the operator's own
/// ones as files; camera and map changing places. Each has its way to look at the map.
class LayoutFeature final : public QObject {
    Q_OBJECT
public:
    LayoutFeature(const ViewContext& context, LayoutBook book, MapFeature& map);

    /// The switch for the top bar.
    [[nodiscard]] LayoutSwitch* bar() const { return m_bar; }
    [[nodiscard]] const WindowLayout& current() const { return m_used; }
    /// False, and told, when there is none of that name.
    bool use(const QString& name);
    /// The same, as the first one of a window: no other says how the map is looked at.
    bool begin(const QString& name);
    /// How the operator looks at the map where layouts leave it open.
    [[nodiscard]] MapSight ownSight() const;
    /// Keeps arrangement and map as they are under @p title, with the keys of the layout in use; false, and
    /// told, when it cannot.
    bool saveAs(const QString& title);

signals:
    /// What the layout now in use binds, by button of the pad: ids of commands.
    void padBound(const std::map<std::string, std::string>& bindings);

private:
    void addCommands();
    void addPanes();  ///< to the View menu, as soon as it is opened
    void fill();      ///< menu and switch with what the book has
    /// Whether this window has most of the panes that @p layout is about.
    [[nodiscard]] bool isOfUse(const WindowLayout& layout) const;
    void addChoice(const WindowLayout& layout, int place);
    void askForTitle();
    /// A name for the file of a layout with that title; of the one of one's own that has it, where there is.
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
