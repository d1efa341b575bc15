#pragma once

#include <QObject>

#include "app/window/live/input/drive_input.h"
#include "app/window/live/live_context.h"

class QAction;

namespace leitstand {

struct LiveMoment;
class DriveStrip;

/// Driving the selected robot: the drive focus, the grant, and the strip that tells what the robot does
/// ("strip").
class DriveFeature final : public QObject {
    Q_OBJECT
public:
    explicit DriveFeature(const LiveContext& context);

    [[nodiscard]] bool driving() const { return m_input.hasFocus(); }
    [[nodiscard]] DriveInput& input() { return m_input; }
    /// Takes the drive focus, and asks for the grant; or lets both sticks and focus go.
    void setDriving(bool on);

private:
    void addCommands();
    void connectStrip();
    void show(const LiveMoment& moment);

    LiveContext m_context;
    DriveInput m_input;
    DriveStrip* m_strip;
    QAction* m_drive = nullptr;
};

}  // namespace leitstand
