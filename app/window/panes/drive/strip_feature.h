#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"

namespace leitstand {

class DriveStrip;
struct LiveMoment;

/// Shows the instruments of the selected robot. Without a live station, the grant to drive the robot cannot
/// be requested.
class StripFeature final : public QObject {
    Q_OBJECT
public:
    explicit StripFeature(const ViewContext& context);

    [[nodiscard]] DriveStrip& pane() const { return *m_strip; }

private:
    void show(const LiveMoment& moment);

    ViewContext m_context;
    DriveStrip* m_strip;
};

}  // namespace leitstand
