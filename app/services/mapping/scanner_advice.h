#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/event/stream_role.h"
#include "core/mapping/calibration/scanner_calibration.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A question to the operator about a robot's 3D scanner, in which the map shows an error.
struct ScannerQuestion {
    std::string robot;       ///< name of the robot
    ScannerCorrection more;  ///< suggested in addition to the correction in its file
    /// Whether both questions are about the same fault of the same scanner, possibly with other figures.
    [[nodiscard]] bool asksAs(const ScannerQuestion& other) const {
        return robot == other.robot && faultOf(more) == faultOf(other.more);
    }
    friend bool operator==(const ScannerQuestion&, const ScannerQuestion&) = default;
};

/// What the map suggests about scanners, and the operator's answers. Any thread.
class ScannerAdvice {
public:
    /// @p mission: folder in which the robots' files are kept beside the log; empty: none.
    ScannerAdvice(std::vector<RobotDescription> robots, std::filesystem::path mission);

    /// Takes @p finding, which is what the map shows about the scanner of @p robot. Ignores it if the scanner
    /// was measured with another correction than the present one. Returns whether to notify the operator:
    /// only for the first question about a fault.
    bool follow(const std::string& robot, const ScannerFinding& finding);
    /// The first unanswered question.
    [[nodiscard]] std::optional<ScannerQuestion> question() const;
    /// Dismisses @p question. LiveMapping::leaveAsIs() prevents that the map suggests it again.
    void leave(const ScannerQuestion& question);

    /// Result of applying a correction.
    struct Used {
        ScannerCorrection total;
        std::string file;        ///< the robot's file that has it now; empty: none
        std::string notWritten;  ///< why no file has it, in words; empty: nothing went wrong
    };
    /// Corrects the scanner in the robot's file, so that the next mission uses it, and in the mission's copy.
    /// A file that came with the program is not changed; a copy is written to the user's folder.
    [[nodiscard]] Used use(const ScannerQuestion& question);

    /// Stores in the mission's copy of @p robot's file that the stream on @p topic makes the map. Errors name
    /// the file.
    [[nodiscard]] Result<void> mapWith(const std::string& robot, const std::string& topic);
    /// Returns the role of @p topic of @p robot if the map can be made from it (RobotDescription::mayMap()).
    [[nodiscard]] std::optional<StreamRole> mappingRole(const std::string& robot,
                                                        const std::string& topic) const;
    /// Returns the topic of the clouds that make the map, for a @p robot with several scanners; empty: none
    /// yet.
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
