#pragma once

#include <map>
#include <string>

#include <QObject>

#include "app/window/live/live_context.h"
#include "widgets/models/live/gas_trend.h"

class QWidget;

namespace leitstand {

class AlarmPanel;
class ClockFace;
class DriveStrip;
class ReviewBridge;
struct LiveMoment;

/// What a robot did ("strip"), which alarms stood ("alarms") and the mission's clock, at the moment of the
/// review.
class ReviewPanes final : public QObject {
    Q_OBJECT
public:
    ReviewPanes(const ViewContext& context, ReviewBridge& bridge);

    [[nodiscard]] QWidget* clock() const;  ///< for the top bar

private:
    void show(const LiveMoment& moment);
    void showStrip(const LiveMoment& moment);

    ViewContext m_context;
    ReviewBridge& m_bridge;
    DriveStrip* m_strip;
    AlarmPanel* m_alarms;
    ClockFace* m_clock;
    std::map<std::string, GasTrend> m_gas;  ///< by robot
};

}  // namespace leitstand
