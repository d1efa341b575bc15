#pragma once

#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "app/services/station/cameras/picture_feed.h"
#include "app/window/source/live_moment.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/map.h"
#include "core/robot/robot_description.h"
#include "widgets/models/live/robots/gas_trend.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/message_list_model.h"

namespace leitstand {

/// The source of what panes show: the station on live robots, a mission's log, or a map that is corrected by
/// hand.
class MomentSource : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] virtual const std::vector<RobotDescription>& robots() const = 0;
    [[nodiscard]] virtual PictureFeed& pictures() = 0;
    /// Selects the robot whose surroundings moment() contains.
    virtual void watch(const std::string& robot) = 0;
    /// Returns when @p picture arrived, on the clock of LiveMoment::steady.
    [[nodiscard]] virtual SteadyTime arrivalOf(const ShownPicture& picture) const = 0;
    /// Returns the ages from which pictures of a camera are stale or lost. The source knows how often they
    /// come.
    [[nodiscard]] virtual FreshnessLimits pictureLimits(const std::string& /*robot*/,
                                                        const std::string& /*sensor*/) const {
        return {};
    }
    /// What the virtual scan of a robot is made of.
    struct ScanSource {
        bool keyScans = false;  ///< made of key scans, whatever their age; else of what its scanners send
        FreshnessLimits limits = {};
    };
    [[nodiscard]] virtual ScanSource scanSource(const std::string& /*robot*/) const { return {}; }
    /// Returns the gas that @p robot measured in the two minutes before moment(), also for a window that is
    /// created later.
    [[nodiscard]] virtual GasTrend gas(const std::string& robot) const = 0;
    /// Returns the moment of the newest tick.
    [[nodiscard]] const LiveMoment& moment() const { return m_moment; }
    /// Returns the messages since the source was opened, the newest 500. They stay when a window is created
    /// again in another language.
    [[nodiscard]] MessageListModel& messages() { return m_messages; }
    /// Shows @p text to the operator, and keeps it in messages().
    void notify(const QString& text);

signals:
    void notified(const QString& text);                    ///< a message for the operator
    void pictured(const leitstand::ShownPicturePtr& one);  ///< the newest picture of a camera
    /// A camera has no picture any more: a review went back to a moment before its first picture.
    void pictureGone(const std::string& robot, const std::string& sensor);
    void mapChanged(const leitstand::MapPtr& map);
    void scansChanged(const leitstand::LiveMapPtr& map);  ///< the map's key scans, and why some do not count
    void ticked(const leitstand::LiveMoment& moment);     ///< up to 30 times a second

protected:
    using QObject::QObject;
    LiveMoment m_moment;

private:
    MessageListModel m_messages{this};
};

}  // namespace leitstand
