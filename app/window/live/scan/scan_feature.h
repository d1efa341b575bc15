#pragma once

#include <QObject>

#include "app/window/live/live_context.h"

namespace leitstand {

struct LiveMoment;
class VirtualScanPane;

/// The virtual 2D scan of the selected robot, in a pane of its own ("scan").
class ScanFeature final : public QObject {
    Q_OBJECT
public:
    explicit ScanFeature(const ViewContext& context);

private:
    void show(const LiveMoment& moment);

    ViewContext m_context;
    VirtualScanPane* m_pane;
};

}  // namespace leitstand
