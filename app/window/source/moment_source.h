#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "app/services/station/cameras/picture_feed.h"
#include "app/window/source/live_moment.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/map.h"
#include "core/robot/robot_description.h"
#include "widgets/models/live/robots/value_trend.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/message_list_model.h"

namespace leitstand {

/// The source of what panes show: the station with live robots, a mission's log, or a map that is corrected
/// by hand.
class MomentSource : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] virtual const std::vector<RobotDescription>& robots() const = 0;
    [[nodiscard]] virtual PictureFeed& pictures() = 0;
    /// Selects the robot whose surroundings are in moment().
    virtual void watch(const std::string& robot) = 0;
    /// Returns when @p picture arrived, in the time of LiveMoment::steady.
    [[nodiscard]] virtual SteadyTime arrivalOf(const ShownPicture& picture) const = 0;
    /// Returns the ages from which pictures of a camera are stale or lost. The source knows how often they
    /// arrive.
    [[nodiscard]] virtual FreshnessLimits pictureLimits(const std::string& /*robot*/,
                                                        const std::string& /*sensor*/) const {
        return {};
    }
    /// What the virtual scan of a robot is made from.
    struct ScanSource {
        /// Whether it is made from key scans, of any age; otherwise from what its scanners send.
        bool keyScans = false;
        FreshnessLimits limits = {};
    };
    [[nodiscard]] virtual ScanSource scanSource(const std::string& /*robot*/) const { return {}; }
    /// Returns the gas that @p robot measured in the two minutes before moment(). Also works for a window
    /// that is created later.
    [[nodiscard]] virtual ValueTrend gas(const std::string& robot) const = 0;
    /// Returns a number that @p robot measured in that time: of the stream on @p topic, StreamDescription::
    /// readings at @p index.
    [[nodiscard]] virtual ValueTrend reading(const std::string& robot, const std::string& topic,
                                             std::size_t index) const = 0;
    /// Returns the moment of the last tick.
    [[nodiscard]] const LiveMoment& moment() const { return m_moment; }
    /// Returns the newest 500 messages since the source was opened. They are kept when a window is created
    /// again in another language.
    [[nodiscard]] MessageListModel& messages() { return m_messages; }
    /// Shows @p text to the operator, and adds it to messages().
    void notify(const QString& text);

signals:
    void notified(const QString& text);                    ///< a message for the operator
    void pictured(const leitstand::ShownPicturePtr& one);  ///< the newest picture of a camera
    /// A camera no longer has a picture, because a review went back to a moment before its first picture.
    void pictureGone(const std::string& robot, const std::string& sensor);
    void mapChanged(const leitstand::MapPtr& map);
    /// The map's key scans, and why some are uncertain or set aside.
    void scansChanged(const leitstand::LiveMapPtr& map);
    void ticked(const leitstand::LiveMoment& moment);  ///< up to 30 times a second

protected:
    using QObject::QObject;
    LiveMoment m_moment;

private:
    MessageListModel m_messages{this};
};

}  // namespace leitstand
