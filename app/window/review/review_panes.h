#pragma once

#include <string>

#include <QObject>

#include "app/window/live/live_context.h"
#include "widgets/models/live/robots/gas_trend.h"

class QWidget;

namespace leitstand {

class AlarmPanel;
class ClockFace;
class DriveStrip;
class ReviewBridge;
class StreamList;
struct LiveMoment;

/// What a robot did ("strip"), what came of its streams ("link"), which alarms stood ("alarms") and the
/// mission's clock, at the moment of the review.
class ReviewPanes final : public QObject {
    Q_OBJECT
public:
    ReviewPanes(const ViewContext& context, ReviewBridge& bridge);

    [[nodiscard]] QWidget* clock() const;  ///< for the top bar

private:
    void show(const LiveMoment& moment);
    void showStrip(const LiveMoment& moment);
    void showStreams(const LiveMoment& moment);
    /// What @p robot measured in the minutes before @p now, as the log has it: also after a jump.
    [[nodiscard]] GasTrend gasUntil(const std::string& robot, Time now) const;

    ViewContext m_context;
    ReviewBridge& m_bridge;
    DriveStrip* m_strip;
    AlarmPanel* m_alarms;
    StreamList* m_streams;
    ClockFace* m_clock;
};

}  // namespace leitstand
