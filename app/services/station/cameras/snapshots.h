#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "app/services/job_queue.h"
#include "app/services/station/cameras/picture_feed.h"
#include "core/base/result.h"
#include "core/robot/control/pan_tilt.h"

namespace leitstand {

/// A picture that shall be stored, and what is known about it.
struct SnapshotRequest {
    ShownPicturePtr picture;
    std::string camera;                   ///< name of the camera for the operator, "Left camera"
    std::optional<Pose> baseInOdom;       ///< the robot's pose in its newest odometry
    std::optional<PanTiltAngles> turned;  ///< how the camera is turned
};

/// Writes snapshots to the folder `snapshots` of a mission, on its own thread. Each is a PNG of the picture
/// as received (infrared: the raw numbers in 16 bits), with robot, camera, stamps and pose as text in the
/// file.
class Snapshots {
public:
    /// Called on the snapshots' own thread.
    struct Listener {
        /// @p file is relative to the mission's folder.
        std::function<void(const std::string& robot, const std::filesystem::path& file)> onWritten;
        std::function<void(const std::string& why)> onProblem;
    };
    Snapshots(std::filesystem::path mission, Listener listener);
    ~Snapshots() { finish(); }
    Snapshots(const Snapshots&) = delete;
    Snapshots& operator=(const Snapshots&) = delete;

    void take(const SnapshotRequest& request);  ///< any thread
    void finish();                              ///< waits until all taken snapshots are written

private:
    [[nodiscard]] Result<std::filesystem::path> write(const SnapshotRequest& request) const;

    const std::filesystem::path m_mission;
    const Listener m_listener;
    JobQueue m_queue;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
