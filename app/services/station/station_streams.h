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

/// What the station requests of the streams of its robots: rates, qualities, what is off. On a thin link, it
/// requests less of everything, in the order of thinRequests(). Requests are kept, and sent again to a robot
/// that comes back. A robot obeys the station that holds the grant to drive it. Any thread.
class StationStreams {
public:
    /// Sends a command to a robot.
    using Send = std::function<Result<void>(const std::string& robot, const StreamCommandSample& command)>;
    /// Notifies the watch on a robot's link that a stream is off, or on again.
    using Pause = std::function<void(const std::string& robot, const std::string& topic, bool off)>;

    StationStreams(std::vector<RobotDescription> robots, Send send, Pause pause);
    StationStreams(const StationStreams&) = delete;
    StationStreams& operator=(const StationStreams&) = delete;

    /// Sets the operator's request for a stream. Errors: the robot has no such stream, or takes no requests.
    Result<void> request(const std::string& robot, const std::string& topic, const StreamRequest& request);
    [[nodiscard]] StreamRequest own(const std::string& robot, const std::string& topic) const;
    /// Returns own() after the reductions of the thin link.
    [[nodiscard]] StreamRequest effective(const std::string& robot, const std::string& topic) const;
    /// Whether @p robot takes requests for streams at all.
    [[nodiscard]] bool takesRequests(const std::string& robot) const;

    /// Sets whether the link to @p robot (empty: to all) is thin.
    void thin(const std::string& robot, bool on);
    [[nodiscard]] bool isThin(const std::string& robot) const;  ///< empty: any of them
    void setThin(const ThinSettings& settings);                 ///< takes effect at once
    [[nodiscard]] ThinSettings thinSettings() const;
    /// Selects the robot whose camera stays on over a thin link: the camera that its driver looks through,
    /// else its first.
    void select(const std::string& robot);
    /// Sets the camera @p sensor that the driver of @p robot looks through.
    void selectCamera(const std::string& robot, const std::string& sensor);

    /// Takes the link of a robot as it is now, and sends what is due; call it several times a second.
    void take(const LinkStatus& link);
    void add(const RobotDescription& robot);  ///< adds one more robot

private:
    /// A request, and since when it stands.
    struct Standing {
        StreamRequest request;
        SteadyTime since;
    };
    struct Line {
        RobotDescription robot;
        RequestBook requests = RequestBook();
        bool thin = false, there = false;
        std::string camera = {};                        ///< sensor that is looked through
        std::map<std::string, StreamCost> costs = {};   ///< by topic, while nothing is requested
        std::map<std::string, Standing> standing = {};  ///< by topic
    };
    [[nodiscard]] Line* find(const std::string& robot);
    [[nodiscard]] const Line* find(const std::string& robot) const;
    /// Whether @p request has stood so long that what is measured of @p topic results from it.
    [[nodiscard]] static bool isSettled(Line& line, const std::string& topic, const StreamRequest& request);
    /// Raises the cost of a reduced stream that costs more than expected; true when it does.
    [[nodiscard]] static bool correct(Line& line, const StreamStatus& stream, const StreamRequest& request);
    /// Learns what streams cost from @p link; true when a thin link has to be shared out again.
    [[nodiscard]] static bool learn(Line& line, const LinkStatus& link);
    void share();  ///< shares the thin link out again

    const Send m_send;
    const Pause m_pause;
    mutable std::mutex m_mutex;  ///< guards all that follows
    std::vector<Line> m_lines;
    std::string m_selected;
    ThinSettings m_settings;
};

}  // namespace leitstand
