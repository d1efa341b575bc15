#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"
#include "core/robot/streams/request_book.h"
#include "core/robot/streams/thin_link.h"

namespace leitstand {

/// What the station requests for the streams of its robots: rates, qualities, what is off. On a thin link it
/// requests less, in the order of thinRequests(). Requests are kept, and sent again to a robot whose link
/// returns. A robot obeys the station that holds the grant to drive it. Any thread.
class StationStreams {
public:
    /// Sends a command to a robot.
    using Send = std::function<Result<void>(const std::string& robot, const StreamCommandSample& command)>;
    /// Notifies the monitor of a robot's link that a stream was switched off, or on again.
    using Pause = std::function<void(const std::string& robot, const std::string& topic, bool off)>;

    StationStreams(std::vector<RobotDescription> robots, Send send, Pause pause);
    StationStreams(const StationStreams&) = delete;
    StationStreams& operator=(const StationStreams&) = delete;

    /// Sets the operator's request for a stream. Errors: the robot has no such stream, or takes no requests.
    Result<void> request(const std::string& robot, const std::string& topic, const StreamRequest& request);
    [[nodiscard]] StreamRequest own(const std::string& robot, const std::string& topic) const;
    /// Returns own() after the reductions for the thin link.
    [[nodiscard]] StreamRequest effective(const std::string& robot, const std::string& topic) const;
    /// Whether @p robot takes requests for streams at all.
    [[nodiscard]] bool takesRequests(const std::string& robot) const;

    /// Sets whether the link to @p robot (empty: to all robots) is thin.
    void thin(const std::string& robot, bool on);
    [[nodiscard]] bool isThin(const std::string& robot) const;  ///< empty: to any of them
    void setThin(const ThinSettings& settings);                 ///< takes effect at once
    [[nodiscard]] ThinSettings thinSettings() const;
    /// Selects the robot that keeps one camera on a thin link: the camera that its driver looks through,
    /// otherwise its first.
    void select(const std::string& robot);
    /// Sets that the driver of @p robot looks through the camera @p sensor.
    void selectCamera(const std::string& robot, const std::string& sensor);

    /// Takes the present link of a robot, and sends what is due. Call several times a second.
    void take(const LinkStatus& link);
    void add(const RobotDescription& robot);  ///< adds one more robot

private:
    /// A request, and since when it has been in force.
    struct Standing {
        StreamRequest request;
        SteadyTime since;
    };
    struct Line {
        RobotDescription robot;
        RequestBook requests = RequestBook();
        bool thin = false, there = false;
        std::string camera = {};                       ///< sensor of the camera that the driver looks through
        std::map<std::string, StreamCost> costs = {};  ///< by topic, if nothing is requested
        std::map<std::string, Standing> standing = {};  ///< by topic
    };
    [[nodiscard]] Line* find(const std::string& robot);
    [[nodiscard]] const Line* find(const std::string& robot) const;
    /// Whether @p request has been in force long enough that the measurements of @p topic result from it.
    [[nodiscard]] static bool isSettled(Line& line, const std::string& topic, const StreamRequest& request);
    /// Raises the cost of a reduced stream that costs more than expected. Returns true if it did.
    [[nodiscard]] static bool correct(Line& line, const StreamStatus& stream, const StreamRequest& request);
    /// Learns from @p link what streams cost. Returns true if the capacity of a thin link must be divided
    /// again.
    [[nodiscard]] static bool learn(Line& line, const LinkStatus& link);
    void share();  ///< divides the capacity of the thin link again

    const Send m_send;
    const Pause m_pause;
    mutable std::mutex m_mutex;  ///< guards all members below
    std::vector<Line> m_lines;
    std::string m_selected;
    ThinSettings m_settings;
};

}  // namespace leitstand
