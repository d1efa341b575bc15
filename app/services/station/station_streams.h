#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"
#include "core/robot/streams/thin_link.h"
#include "core/robot/streams/wish_book.h"

namespace leitstand {

/// What the station wants of the streams of its robots: rates, qualities, what is off; and the thin link,
/// which asks for less of everything in the stated order (thinWishes()). Wishes are remembered and said again
/// to a robot that comes back. Robots obey whoever holds the grant to drive them. Any thread.
class StationStreams {
public:
    /// Sends a command to a robot.
    using Send = std::function<Result<void>(const std::string& robot, const StreamCommandSample& command)>;
    /// Tells the watch on a robot's link that a stream is off.
    using Pause = std::function<void(const std::string& robot, const std::string& topic, bool off)>;

    StationStreams(std::vector<RobotDescription> robots, Send send, Pause pause);
    StationStreams(const StationStreams&) = delete;
    StationStreams& operator=(const StationStreams&) = delete;

    /// The operator's wish for a stream. Errors: the robot has no such stream, or takes no wishes.
    Result<void> wish(const std::string& robot, const std::string& topic, const StreamWish& wish);
    [[nodiscard]] StreamWish own(const std::string& robot, const std::string& topic) const;
    /// With what the thin link makes of it.
    [[nodiscard]] StreamWish effective(const std::string& robot, const std::string& topic) const;
    /// Whether @p robot can be asked at all.
    [[nodiscard]] bool takesWishes(const std::string& robot) const;

    /// The link to @p robot (empty: to all) is thin, or is not any more.
    void thin(const std::string& robot, bool on);
    [[nodiscard]] bool isThin(const std::string& robot) const;  ///< empty: any of them
    void setThin(const ThinSettings& settings);                 ///< at once
    [[nodiscard]] ThinSettings thinSettings() const;
    /// Whose camera survives on a thin link: the one that is looked through, its first where none was said.
    void select(const std::string& robot);
    /// The driver of @p robot looks through the camera @p sensor.
    void lookThrough(const std::string& robot, const std::string& sensor);

    /// The link of a robot as it is now: to be told several times a second; what is due goes out.
    void take(const LinkStatus& link);
    void add(const RobotDescription& robot);  ///< one more

private:
    /// A wish, and since when it stands.
    struct Standing {
        StreamWish wish;
        SteadyTime since;
    };
    struct Line {
        RobotDescription robot;
        WishBook wishes = WishBook();
        bool thin = false, there = false;
        std::string camera = {};                        ///< sensor that is looked through
        std::map<std::string, StreamCost> costs = {};   ///< by topic, of what comes while nothing is wished
        std::map<std::string, Standing> standing = {};  ///< by topic
    };
    [[nodiscard]] Line* find(const std::string& robot);
    [[nodiscard]] const Line* find(const std::string& robot) const;
    /// Whether what is measured of @p topic is what comes under @p wish.
    [[nodiscard]] static bool isSettled(Line& line, const std::string& topic, const StreamWish& wish);
    /// What a reduced stream costs more than was thought; true when it does.
    [[nodiscard]] static bool correct(Line& line, const StreamStatus& stream, const StreamWish& wish);
    /// True when a thin link has to be shared anew.
    [[nodiscard]] static bool learn(Line& line, const LinkStatus& link);
    void share();  ///< the thin link anew

    const Send m_send;
    const Pause m_pause;
    mutable std::mutex m_mutex;  ///< of all that follows
    std::vector<Line> m_lines;
    std::string m_selected;
    ThinSettings m_settings;
};

}  // namespace leitstand
