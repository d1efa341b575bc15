#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/perception/heat/heat.h"
#include "core/perception/omni/panorama.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/contrast.h"
#include "core/perception/pictures/picture.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct CameraInfoSample;

/// How the operator wants to see pictures of a camera. Log and snapshots store the pictures as received.
struct PictureLook {
    ContrastHelp contrast = ContrastHelp::Off;  ///< not used for infrared cameras
    bool unwrapped = false;                     ///< whether to show a panorama, for an omnidirectional camera
    friend bool operator==(const PictureLook&, const PictureLook&) = default;
};

/// A picture that is ready to be shown.
struct ShownPicture {
    std::string robot, sensor;   ///< sensor: StreamDescription::sensor
    std::uint64_t sequence = 0;  ///< sequence of its event; not changed when only the look changed
    PictureSample sample;        ///< as received
    /// With the look applied; thermal if the camera measures temperatures.
    std::variant<Picture, ThermalPicture> content;
    Time stamp{}, received{};                        ///< on the robot's clock, and on the station's
    std::uint64_t fingerprint = 0;                   ///< contentHash() of the sample's bytes
    ContrastHelp contrast = ContrastHelp::Off;       ///< contrast that was applied to the content
    std::optional<PanoramaShape> panorama;           ///< shape of the content if it is a panorama
    std::shared_ptr<const CameraInfoSample> camera;  ///< calibration; null: none was received yet
    int width = 0, height = 0;                       ///< size of the picture as received [px]
    std::vector<HeatBlob> heat;                      ///< warm things in a thermal picture
};
using ShownPicturePtr = std::shared_ptr<const ShownPicture>;

/// Decodes pictures on its own thread, always the newest of each camera. A picture that is received while it
/// is busy replaces the waiting one (the log has all). Any thread.
class PictureFeed {
public:
    /// Called on the feed's thread.
    struct Listener {
        std::function<void(const ShownPicturePtr&)> onPicture;
        std::function<void(const std::string&)>
            onProblem;  ///< called with a text about the first damaged picture of a camera
    };

    PictureFeed(std::vector<RobotDescription> robots, Listener listener);
    ~PictureFeed();
    PictureFeed(const PictureFeed&) = delete;
    PictureFeed& operator=(const PictureFeed&) = delete;

    void onEvent(const Event& event);  ///< takes pictures and camera infos; ignores other events
    /// Sets how pictures of a camera are shown from now on. Its newest picture is shown again.
    void setLook(const std::string& robot, const std::string& sensor, const PictureLook& look);

private:
    using Camera = std::pair<std::string, std::string>;  ///< robot, sensor
    struct Work {
        Event event;
        PictureLook look;
        std::shared_ptr<const CameraInfoSample> info;
    };
    void run(const std::stop_token& stop);
    void decode(const Work& work, const std::stop_token& stop);
    void apply(const Work& work, Picture picture, ShownPicture& shown);
    [[nodiscard]] const RobotDescription* robot(const std::string& name) const;
    [[nodiscard]] const ThermalScale* scaleOf(const Event& event) const;
    [[nodiscard]] const Panorama* panoramaOf(const Work& work, const Picture& picture);

    const std::vector<RobotDescription> m_robots;
    const Listener m_listener;
    std::mutex m_mutex;
    std::condition_variable_any m_came;
    std::map<Camera, Event> m_waiting, m_newest;
    std::map<Camera, PictureLook> m_looks;
    std::map<Camera, std::shared_ptr<const CameraInfoSample>> m_infos;
    // of the feed's thread
    std::map<Camera, PictureDecoder> m_decoders;
    std::map<Camera, std::string> m_problems;
    std::map<Camera, Panorama> m_panoramas;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
