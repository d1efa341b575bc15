#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/event/picture_samples.h"
#include "core/perception/depth/depth_cloud.h"
#include "core/perception/pictures/video/video_chains.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct RawEvent;
struct Event;

/// Samples of a topic that could not be decoded.
struct DecodingErrors {
    std::uint64_t count = 0;
    std::string last;  ///< text of the last error: topic, type and what was expected
};

/// Decodes received samples to events of core. Knows the robot and the role of each topic from the robots'
/// files. Ignores other topics, except those of stations. Links pictures of videos with those before them, so
/// it has to be given the events of such a topic in order. Depth pictures on streams of points become clouds,
/// once the camera's calibration was among the events. One thread at a time.
class EventDecoder {
public:
    explicit EventDecoder(std::vector<RobotDescription> robots);

    /// Calls @p take for each event decoded from @p event: usually one, but several on a topic that robots
    /// share ("/tf"). Does not call it when the topic is unknown or the sample is damaged.
    void decode(const RawEvent& event, const std::function<void(const Event&)>& take);
    /// Call where events do not follow those before: pictures of videos cannot be decoded until their next
    /// key picture comes. enterLog() makes them ready.
    void jump() { m_videos.forgetAll(); }
    void jump(const std::string& topic) { m_videos.forget(topic); }
    /// Whether a video was among the events on @p topic so far.
    [[nodiscard]] bool isVideo(const std::string& topic) const { return m_videos.isVideo(topic); }
    /// Whether decode() can decode events on @p topic.
    [[nodiscard]] bool knows(const std::string& topic) const;
    /// Samples that could not be decoded so far, by topic.
    [[nodiscard]] const std::map<std::string, DecodingErrors>& errors() const { return m_errors; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_robots; }

private:
    struct Listing {
        std::size_t robot, stream;
    };
    /// A depth camera: what makes clouds of its pictures.
    struct DepthCamera {
        std::optional<CameraInfoSample> calibration;
        DepthCloud clouds;
        int waiting = 0;  ///< pictures so far without a calibration
    };
    /// Links, or converts, what @p event holds, where it must. Empty: it cannot be used yet.
    [[nodiscard]] Result<std::optional<Event>> finished(Event event);
    [[nodiscard]] Result<std::optional<Event>> asCloud(Event event);
    void complain(const std::string& topic, const std::string& text);

    std::vector<RobotDescription> m_robots;
    std::multimap<std::string, Listing> m_listings;  ///< by topic
    std::map<std::string, DecodingErrors> m_errors;
    VideoChains m_videos;
    std::map<std::pair<std::string, std::string>, DepthCamera> m_depths;  ///< by robot and sensor
};

}  // namespace leitstand
