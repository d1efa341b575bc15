#pragma once

#include <QObject>

#include "app/window/input/drive_input.h"
#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

class DriveStrip;

/// Drives the selected robot: its keys, the drive focus, and the grant that the strip requests.
class DriveFeature final : public QObject {
    Q_OBJECT
public:
    DriveFeature(const LiveContext& context, DriveStrip& strip);

    [[nodiscard]] bool driving() const { return m_input.hasFocus(); }
    [[nodiscard]] DriveInput& input() { return m_input; }
    /// Takes the drive focus and requests the grant, or releases sticks and focus.
    void setDriving(bool on);

private:
    void addCommands();
    void connectStrip(DriveStrip& strip);

    LiveContext m_context;
    DriveInput m_input;
    QAction* m_drive = nullptr;
};

}  // namespace leitstand
