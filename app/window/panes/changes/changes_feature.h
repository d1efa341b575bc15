#pragma once

#include <QObject>
#include <QTimer>

#include "app/services/comparison/change_finder.h"
#include "app/window/panes/view_context.h"

class QAction;
class QWidget;

namespace leitstand {

class ChangesPanel;
class MapFeature;

/// Shows what has appeared and disappeared since the earlier missions, if the map is made from several
/// missions. It is shown in the map and as a list ("changes").
class ChangesFeature final : public QObject {
    Q_OBJECT
public:
    ChangesFeature(const ViewContext& context, MapFeature& map);
    ~ChangesFeature() override;

    [[nodiscard]] QWidget& pane() const;

private:
    void addCommands();
    void setMap(const MapPtr& map);
    void show(bool shown);
    void showChosen();
    void follow();
    void list();  ///< lists the changes, with distances from the selected robot

    ViewContext m_context;
    MapFeature& m_map;
    ChangesPanel* m_panel;
    QAction* m_shown = nullptr;  ///< whether the map shows the changes
    MapPtr m_newest;             ///< null: none was received
    MapChangesPtr m_changes;
    QTimer m_look;
    ChangeFinder m_finder;
};

}  // namespace leitstand
