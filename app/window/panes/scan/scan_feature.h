#pragma once

#include <Eigen/Core>
#include <QObject>

#include "app/window/panes/view_context.h"

class QWidget;

namespace leitstand {

struct LiveMoment;
class VirtualScanPane;

/// The virtual 2D scan of the selected robot, in its own pane.
class ScanFeature final : public QObject {
    Q_OBJECT
public:
    explicit ScanFeature(const ViewContext& context);

    [[nodiscard]] QWidget& pane() const;
    void setPointing(bool pointing);  ///< sets whether the next click into the pane emits pointed()

signals:
    void pointed(const Eigen::Vector2d& place);  ///< in the selected robot's base_link [m]
    void pointingEnded();

private:
    void show(const LiveMoment& moment);

    ViewContext m_context;
    VirtualScanPane* m_pane;
};

}  // namespace leitstand
