#pragma once

#include <QObject>

#include "app/window/live/live_context.h"

class QMenu;
class QWidget;

namespace leitstand {

struct LiveMoment;
class RobotBar;
class StopButton;

/// All robots: which one is selected, the modes asked of it, STOP and its release.
class RobotsFeature final : public QObject {
    Q_OBJECT
public:
    explicit RobotsFeature(const LiveContext& context);

    [[nodiscard]] QWidget* bar() const;   ///< for the top bar
    [[nodiscard]] QWidget* stop() const;  ///< for its corner

signals:
    void told(const QString& text);

private:
    void addCommands();
    void fillModes(QMenu& modes);
    void show(const LiveMoment& moment);

    LiveContext m_context;
    RobotBar* m_bar;
    StopButton* m_stop;
};

}  // namespace leitstand
