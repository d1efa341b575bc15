#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"

class QMenu;
class QWidget;

namespace leitstand {

struct LiveMoment;
class RobotBar;
class StopButton;

/// Shows all robots and lets the operator select one. For live robots it also has mode requests, STOP and its
/// release.
class RobotsFeature final : public QObject {
    Q_OBJECT
public:
    explicit RobotsFeature(const ViewContext& context);

    [[nodiscard]] QWidget* bar() const;   ///< widget for the top bar
    [[nodiscard]] QWidget* stop() const;  ///< STOP, for its corner; null: there are no robots to stop

private:
    void addChoice();
    void addStop(Station& station);
    void addCommands(Station& station);
    void fillModes(QMenu& modes);
    void show(const LiveMoment& moment);

    ViewContext m_context;
    RobotBar* m_bar;
    StopButton* m_stop = nullptr;
};

}  // namespace leitstand
