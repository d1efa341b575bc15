#pragma once

#include <QList>
#include <QObject>

#include "app/window/map/view_state.h"

class QAction;
class QActionGroup;
class QMenu;

namespace leitstand {

class MapView;

/// Commands for the view of the map, in a menu and in the tool column.
class ViewCommands final : public QObject {
    Q_OBJECT
public:
    /// Which keys the commands have.
    enum class Keys {
        Plain,  ///< those of Aside, and also 1 to 3 and letters without modifiers
        /// Alt with 1 to 3, Ctrl and Shift with letters, because plain keys have other uses in the window.
        Aside,
    };
    /// What Esc does.
    enum class Escape {
        EndsMeasuring,
        StopsRobots,  ///< stops robots; only the command itself ends measuring
    };
    /// The commands change @p state and move the camera of @p view; both must outlive this object.
    ViewCommands(ViewState& state, MapView& view, QObject* parent, Keys keys = Keys::Plain,
                 Escape escape = Escape::EndsMeasuring);

    /// Puts the commands into @p menu.
    void fill(QMenu& menu);
    /// Returns the commands for the column of tools, from top to bottom; null is a gap.
    [[nodiscard]] QList<QAction*> tools() const;
    /// Takes the number of scans in the map. If there are none, before() and measure() are disabled.
    void setScans(int scans);
    /// The map shows the poses before registration while this action is checked.
    [[nodiscard]] QAction& before() const { return *m_before; }
    /// Clicks measure distances while this action is checked.
    [[nodiscard]] QAction& measure() const { return *m_measure; }

private:
    void addLooks();
    void addColourings();
    void addThemes();
    void addCameras(MapView& view);
    void addTools(MapView& view, Escape escape);
    void addEscape(MapView& view);
    void showState();
    void setClipping(bool on);
    void addPlainKeys();

    ViewState& m_state;
    QActionGroup* m_looks;
    QActionGroup* m_colourings;
    QActionGroup* m_themes;
    QList<QAction*> m_cameras;
    QAction* m_before = nullptr;
    QAction* m_clip = nullptr;
    QAction* m_measure = nullptr;
};

}  // namespace leitstand
