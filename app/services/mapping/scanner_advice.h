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
    /// Whether both ask about the same error of the same scanner, perhaps with other figures.
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

    /// Takes what the map finds about @p robot's scanner, unless it was measured with another correction than
    /// the present one. Returns whether to notify the operator: only of the first question of its kind.
    bool follow(const std::string& robot, const ScannerFinding& finding);
    /// The first question without an answer.
    [[nodiscard]] std::optional<ScannerQuestion> question() const;
    /// Dismisses the question. LiveMapping remembers what was left, and does not advise it again.
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

private:
    mutable std::mutex m_mutex;
    std::vector<RobotDescription> m_robots;
    const std::filesystem::path m_mission;
    std::map<std::string, ScannerCorrection> m_advised;  ///< by robot
    std::set<std::pair<std::string, ScannerFault>> m_reported;
    [[nodiscard]] std::vector<RobotDescription>::iterator find(const std::string& robot);
};

/// Returns the sensor of @p robot that the map is made with: that of its only stream of points. Empty: there
/// is none, or there are several.
[[nodiscard]] std::string onlyScanner(const RobotDescription& robot);

}  // namespace leitstand
