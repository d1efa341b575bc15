#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/calibration/scanner_calibration.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A question to the operator about a robot's 3D scanner that the map finds in error.
struct ScannerQuestion {
    std::string robot;       ///< name
    ScannerCorrection more;  ///< in addition to what its file holds
    /// Whether both questions are about the same fault of the same scanner, perhaps with other figures.
    [[nodiscard]] bool asksAs(const ScannerQuestion& other) const {
        return robot == other.robot && faultOf(more) == faultOf(other.more);
    }
    friend bool operator==(const ScannerQuestion&, const ScannerQuestion&) = default;
};

/// The map's advice on scanners, and the operator's answers. Any thread.
class ScannerAdvice {
public:
    /// @p mission: the folder that keeps the robots' files beside the log; empty: none.
    ScannerAdvice(std::vector<RobotDescription> robots, std::filesystem::path mission);

    /// Takes @p finding, what the map finds about the scanner of @p robot. Ignores it if the scanner was
    /// measured with another correction than the present one. Returns whether to notify the operator: only of
    /// the first question on a fault.
    bool follow(const std::string& robot, const ScannerFinding& finding);
    /// The first question without an answer.
    [[nodiscard]] std::optional<ScannerQuestion> question() const;
    /// Dismisses @p question. LiveMapping::leaveAsIs() makes the map not advise it again.
    void leave(const ScannerQuestion& question);

    /// Result of applying a correction.
    struct Used {
        ScannerCorrection total;
        std::string file;        ///< the robot's file that holds it now; empty: none
        std::string notWritten;  ///< why no file holds it, in words; empty: nothing went wrong
    };
    /// Corrects the scanner in the robot's file, so that the next mission begins with it, and in the
    /// mission's copy. A file that came with the program stays unchanged; a copy goes to the user's folder.
    [[nodiscard]] Used use(const ScannerQuestion& question);

    /// Keeps in the mission's copy of @p robot's file that the stream on @p topic makes the map. Errors name
    /// the file.
    [[nodiscard]] Result<void> mapWith(const std::string& robot, const std::string& topic);
    [[nodiscard]] bool hasClouds(const std::string& robot, const std::string& topic) const;
    /// Returns the topic whose clouds make the map of @p robot, which has several; empty: none yet.
    [[nodiscard]] std::string mapsWith(const std::string& robot) const;

private:
    mutable std::mutex m_mutex;
    std::vector<RobotDescription> m_robots;
    const std::filesystem::path m_mission;
    std::map<std::string, ScannerCorrection> m_advised;  ///< by robot
    std::set<std::pair<std::string, ScannerFault>> m_reported;
    [[nodiscard]] std::vector<RobotDescription>::iterator find(const std::string& robot);
};

/// Returns the sensor of RobotDescription::mappingStream(); empty: there is none, or it names none.
[[nodiscard]] std::string mappingSensor(const RobotDescription& robot);

}  // namespace leitstand
