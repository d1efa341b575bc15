#pragma once

#include <QList>
#include <QObject>

#include "app/window/view_state.h"

class QAction;
class QActionGroup;
class QMenu;

namespace leitstand {

class MapView;

/// How the map is looked at: the View menu and the tool column.
class ViewCommands final : public QObject {
    Q_OBJECT
public:
    /// The commands change @p state and move the camera of @p view; both must outlive them. Looks are on 1 to
    /// 3 with @p lookKeys.
    ViewCommands(ViewState& state, MapView& view, QObject* parent, Qt::KeyboardModifiers lookKeys = {});

    /// Puts the commands into @p menu.
    void fill(QMenu& menu);
    /// The tool column's, from top to bottom; a null stands for a gap.
    [[nodiscard]] QList<QAction*> tools() const;
    /// Poses before registration and measuring make sense only for a map that has scans.
    void setScans(int scans);
    /// Shows the poses before registration while checked.
    [[nodiscard]] QAction& before() const { return *m_before; }
    /// Measures while checked.
    [[nodiscard]] QAction& measure() const { return *m_measure; }

private:
    void addLooks(Qt::KeyboardModifiers keys);
    void addColourings();
    void addThemes();
    void addCameras(MapView& view);
    void addTools(MapView& view);
    void addEscape(MapView& view);
    void showState();
    void setClipping(bool on);

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
