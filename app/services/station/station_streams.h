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

/// What the station requests of the streams of its robots: rates, qualities, what is off. A thin link
/// requests less of everything in the stated order (thinRequests()). Wishes are kept, and sent again to a
/// robot that comes back. Robots obey whoever holds the grant to drive them. Any thread.
class StationStreams {
public:
    /// Sends a command to a robot.
    using Send = std::function<Result<void>(const std::string& robot, const StreamCommandSample& command)>;
    /// Notifies the watch on a robot's link whether a stream is off.
    using Pause = std::function<void(const std::string& robot, const std::string& topic, bool off)>;

    StationStreams(std::vector<RobotDescription> robots, Send send, Pause pause);
    StationStreams(const StationStreams&) = delete;
    StationStreams& operator=(const StationStreams&) = delete;

    /// Sets the operator's wish for a stream. Errors: the robot has no such stream, or takes no wishes.
    Result<void> request(const std::string& robot, const std::string& topic, const StreamRequest& request);
    [[nodiscard]] StreamRequest own(const std::string& robot, const std::string& topic) const;
    /// The wish after the reductions of the thin link.
    [[nodiscard]] StreamRequest effective(const std::string& robot, const std::string& topic) const;
    /// Whether @p robot takes wishes at all.
    [[nodiscard]] bool takesRequests(const std::string& robot) const;

    /// Sets whether the link to @p robot (empty: to all) is thin.
    void thin(const std::string& robot, bool on);
    [[nodiscard]] bool isThin(const std::string& robot) const;  ///< empty: any of them
    void setThin(const ThinSettings& settings);                 ///< takes effect at once
    [[nodiscard]] ThinSettings thinSettings() const;
    /// Selects the robot whose camera survives on a thin link: the one that is looked through, else its
    /// first.
    void select(const std::string& robot);
    /// Sets the camera @p sensor that the driver of @p robot looks through.
    void selectCamera(const std::string& robot, const std::string& sensor);

    /// Takes the link of a robot as it is now, and sends what is due; call it several times a second.
    void take(const LinkStatus& link);
    void add(const RobotDescription& robot);  ///< adds one more robot

private:
    /// A wish, and since when it stands.
    struct Standing {
        StreamRequest request;
        SteadyTime since;
    };
    struct Line {
        RobotDescription robot;
        RequestBook requests = RequestBook();
        bool thin = false, there = false;
        std::string camera = {};                        ///< sensor that is looked through
        std::map<std::string, StreamCost> costs = {};   ///< by topic, while nothing is wished
        std::map<std::string, Standing> standing = {};  ///< by topic
    };
    [[nodiscard]] Line* find(const std::string& robot);
    [[nodiscard]] const Line* find(const std::string& robot) const;
    /// Whether what is measured of @p topic already results from @p request.
    [[nodiscard]] static bool isSettled(Line& line, const std::string& topic, const StreamRequest& request);
    /// Raises the cost of a reduced stream that costs more than expected; true when it does.
    [[nodiscard]] static bool correct(Line& line, const StreamStatus& stream, const StreamRequest& request);
    /// True when a thin link has to be shared again.
    [[nodiscard]] static bool learn(Line& line, const LinkStatus& link);
    void share();  ///< shares the thin link again

    const Send m_send;
    const Pause m_pause;
    mutable std::mutex m_mutex;  ///< guards all that follows
    std::vector<Line> m_lines;
    std::string m_selected;
    ThinSettings m_settings;
};

}  // namespace leitstand
