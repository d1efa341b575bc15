#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/event/event.h"
#include "core/event/picture_samples.h"

namespace leitstand {

/// What one robot sent in the last seconds that may show a find. Nothing is decoded or copied.
struct RobotEvidence {
    std::map<std::string, std::vector<Event>> pictures;  ///< pictures of cameras, by sensor, oldest first
    /// Pictures of thermal cameras, by sensor, oldest first.
    std::map<std::string, std::vector<Event>> thermal;
    std::map<std::string, CameraInfoSample> cameras;  ///< calibrations of both, by sensor
    std::optional<Event> scan, odometry, sightings;   ///< newest
    std::vector<Event> gas;                           ///< those of the last minute, oldest first
};

/// Keeps what robots sent in the last seconds, until the operator sees something. Any thread.
class RecentEvidence {
public:
    static constexpr std::chrono::seconds Pictures{3};  ///< how long pictures are kept
    static constexpr std::chrono::seconds Gas{60};
    /// A sensor that has been silent for longer is left out.
    static constexpr std::chrono::seconds Silence{10};
    static constexpr std::size_t MostPictures = 120;  ///< largest number of pictures per camera

    void onEvent(const Event& event);
    /// Returns what @p robot sent, as of @p now (station's clock), without what is too old. @p pointed: event
    /// of the picture that a person looks at; it is returned even if it is older; 0: none. Empty when the
    /// robot sent nothing.
    [[nodiscard]] RobotEvidence of(const std::string& robot, Time now, std::uint64_t pointed = 0) const;

private:
    using Camera = std::pair<std::string, std::string>;  ///< robot, sensor
    struct Newest {
        std::optional<Event> scan, odometry, sightings;
        std::deque<Event> gas;
    };
    mutable std::mutex m_mutex;
    std::map<Camera, std::deque<Event>> m_pictures;
    std::map<Camera, CameraInfoSample> m_infos;
    std::map<std::string, Newest> m_newest;
};

}  // namespace leitstand
