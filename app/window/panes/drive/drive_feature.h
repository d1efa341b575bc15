#pragma once

#include <QObject>

#include "app/window/input/drive_input.h"
#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

class DriveStrip;

/// Lets the operator drive the selected robot with keys or gamepad. Requests the grant to drive it when
/// driving begins. In the strip, the operator can also request the grant, give it up, or answer another
/// station that requests it.
class DriveFeature final : public QObject {
    Q_OBJECT
public:
    DriveFeature(const LiveContext& context, DriveStrip& strip);

    [[nodiscard]] bool driving() const { return m_input.hasFocus(); }
    [[nodiscard]] DriveInput& input() { return m_input; }
    /// True: requests the grant and gives the keys the drive focus. False: releases sticks and focus.
    void setDriving(bool on);

private:
    void addCommands();
    void connectStrip(DriveStrip& strip);

    LiveContext m_context;
    DriveInput m_input;
    QAction* m_drive = nullptr;
};

}  // namespace leitstand
