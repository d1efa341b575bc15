#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/time.h"
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
/// it has to be given the events of such a topic in order. Of depth pictures on streams of points, five a
/// second and camera become clouds, once the camera's calibration was among the events; others are passed
/// over. One thread at a time.
class EventDecoder {
public:
    explicit EventDecoder(std::vector<RobotDescription> robots);

    /// Calls @p take for each event decoded from @p event: usually one, but several on a topic that robots
    /// share ("/tf"). Does not call it when the topic is unknown or the sample is damaged.
    void decode(const RawEvent& event, const std::function<void(const Event&)>& take);
    /// Call where events do not follow those before: pictures of videos cannot be decoded until their next
    /// key picture comes. enterLog() makes them ready.
    void jump() {
        m_videos.forgetAll();
        m_place.reset();
    }
    void jump(const std::string& topic) { m_videos.forget(topic); }
    /// Call when all events of @p topics up to @p sequence were decoded in order: who reads the same topics
    /// on from there need not jump (goesOn()).
    void arrived(std::uint64_t sequence, const std::vector<std::string>& topics) {
        m_place = {sequence, topics};
    }
    [[nodiscard]] bool goesOn(std::uint64_t sequence, const std::vector<std::string>& topics) const {
        return m_place && m_place->sequence == sequence && m_place->topics == topics;
    }
    /// Without content, clouds of depth pictures are empty: enough to fold them, and quicker.
    void setDepths(bool content) { m_depthContent = content; }
    /// Whether the calibration of the depth camera @p sensor of @p robot is known, or there is no such
    /// camera.
    [[nodiscard]] bool isCalibrated(const std::string& robot, const std::string& sensor) const;
    /// Whether an event on @p topic was decoded so far.
    [[nodiscard]] bool hasSeen(const std::string& topic) const { return m_seen.contains(topic); }
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
        int waiting = 0;           ///< pictures so far without a calibration
        std::optional<Time> last;  ///< when the newest one that became a cloud was received
    };
    /// Links, or converts, what @p event holds, where it must. Empty: it cannot be used yet.
    [[nodiscard]] Result<std::optional<Event>> finished(Event event);
    [[nodiscard]] Result<std::optional<Event>> asCloud(Event event);
    void complain(const std::string& topic, const std::string& text);

    std::vector<RobotDescription> m_robots;
    std::multimap<std::string, Listing> m_listings;  ///< by topic
    std::map<std::string, DecodingErrors> m_errors;
    VideoChains m_videos;
    /// Up to where was read last, and what.
    struct Place {
        std::uint64_t sequence = 0;
        std::vector<std::string> topics;
    };
    std::optional<Place> m_place;
    std::set<std::string> m_seen;  ///< topics
    bool m_depthContent = true;
    std::map<std::pair<std::string, std::string>, DepthCamera> m_depths;  ///< by robot and sensor
};

}  // namespace leitstand
