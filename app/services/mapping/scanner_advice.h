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

/// What the operator is asked about a robot's 3D scanner, which the map finds to be off.
struct ScannerQuestion {
    std::string robot;       ///< name
    ScannerCorrection more;  ///< beyond what its file says
    /// Whether both ask about the same error of the same scanner, perhaps by other figures.
    [[nodiscard]] bool asksAs(const ScannerQuestion& other) const {
        return robot == other.robot && faultOf(more) == faultOf(other.more);
    }
    friend bool operator==(const ScannerQuestion&, const ScannerQuestion&) = default;
};

/// What the map advises about scanners, and what the operator made of it. Any thread.
class ScannerAdvice {
public:
    /// @p mission: the folder that keeps the robots' files beside the log; empty: none.
    ScannerAdvice(std::vector<RobotDescription> robots, std::filesystem::path mission);

    /// The map advises @p more for @p robot's scanner now, or nothing. Whether the operator is to be told: of
    /// a question of its kind for the first time.
    bool follow(const std::string& robot, const std::optional<ScannerCorrection>& more);
    /// The first one that is not answered.
    [[nodiscard]] std::optional<ScannerQuestion> question() const;
    /// Takes the question back. LiveMapping remembers what was left, and does not advise it again.
    void leave(const ScannerQuestion& question);

    /// What became of a correction that is used.
    struct Used {
        ScannerCorrection total;
        std::string file;        ///< the robot's file that has it now; empty: none
        std::string notWritten;  ///< why none has, in words; empty: nothing went wrong
    };
    /// The scanner is corrected: in the robot's file, so that the next mission begins with it, and in the
    /// mission's copy. A file that came with the program stays; a copy goes to the user's folder.
    [[nodiscard]] Used use(const ScannerQuestion& question);

private:
    mutable std::mutex m_mutex;
    std::vector<RobotDescription> m_robots;
    const std::filesystem::path m_mission;
    std::map<std::string, ScannerCorrection> m_advised;  ///< by robot
    std::set<std::pair<std::string, ScannerFault>> m_told;
    [[nodiscard]] std::vector<RobotDescription>::iterator find(const std::string& robot);
};

/// The sensor of @p robot that the map is made with: of its only stream of points. Empty: there is none, or
/// there are several.
[[nodiscard]] std::string onlyScanner(const RobotDescription& robot);

}  // namespace leitstand
