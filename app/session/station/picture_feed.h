#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "core/mission/event.h"
#include "core/perception/picture.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A picture ready to be shown.
struct ShownPicture {
    std::string robot, sensor;                      ///< sensor: StreamDescription::sensor
    std::variant<Picture, ThermalPicture> content;  ///< thermal where the camera measures
    Time stamp{}, received{};                       ///< robot's and station's clock
    std::uint64_t fingerprint = 0;                  ///< contentHash() of the sample's bytes
};
using ShownPicturePtr = std::shared_ptr<const ShownPicture>;

/// Decodes pictures on a thread of its own, of each camera always the newest: what comes while it is at work
/// takes the place of what waits (the log keeps all). Any thread.
class PictureFeed {
public:
    /// Called on the feed's thread.
    struct Listener {
        std::function<void(const ShownPicturePtr&)> onPicture;
        std::function<void(const std::string&)>
            onProblem;  ///< a camera's first picture that is none, in words
    };

    PictureFeed(std::vector<RobotDescription> robots, Listener listener);
    ~PictureFeed();
    PictureFeed(const PictureFeed&) = delete;
    PictureFeed& operator=(const PictureFeed&) = delete;

    void take(const Event& event);  ///< other events are passed by

private:
    using Camera = std::pair<std::string, std::string>;  ///< robot, sensor
    void run(const std::stop_token& stop);
    void decode(const Event& event);
    [[nodiscard]] const ThermalScale* scaleOf(const Event& event) const;

    const std::vector<RobotDescription> m_robots;
    const Listener m_listener;
    std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::map<Camera, Event> m_waiting;
    std::map<Camera, std::string> m_problems;  ///< of the feed's thread
    std::jthread m_thread;                     ///< last: joined first
};

}  // namespace leitstand
