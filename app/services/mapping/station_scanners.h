#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/services/mapping/scanner_advice.h"
#include "core/base/result.h"

namespace leitstand {

class LiveMapping;
struct LiveMappingListener;

/// What StationScanners needs of its station. Any thread.
struct StationScannersContext {
    std::function<Result<void>()> granted;  ///< returns the error, in words, if another station has the map
    std::function<std::string(const std::string&)> titleOf;  ///< returns the title of a robot
    std::function<void(const std::string&)> notify;          ///< tells the operator a text
};

/// The scanners with which a station's robots make the map: which one it is, and the errors that the map
/// shows of it. Any thread; no call waits for the mapping.
class StationScanners {
public:
    /// @p robots and @p mission: as for ScannerAdvice.
    StationScanners(std::vector<RobotDescription> robots, std::filesystem::path mission,
                    StationScannersContext context);

    /// Has @p listener tell of scanners. Call before the mapping begins.
    void listen(LiveMappingListener& listener);
    /// Sets the mapping, which must exist as long as this. Call before any of the following.
    void attach(LiveMapping& mapping) { m_mapping = &mapping; }

    /// Makes the map with the scanner of @p robot whose clouds are on @p topic, from its next cloud on.
    /// Errors, in words: another station has the map, or the robot has no such clouds.
    Result<void> mapWith(const std::string& robot, const std::string& topic);
    /// Returns the topic of the clouds that make the map, for a @p robot with several scanners; empty: they
    /// are still being compared.
    [[nodiscard]] std::string mapsWith(const std::string& robot) const;

    /// Returns a question about a scanner in which the map shows an error. Empty: there is none, the operator
    /// has answered, or another station has the map.
    [[nodiscard]] std::optional<ScannerQuestion> question() const;
    /// Answers @p asked. @p correct: the scanner is corrected from its next scan on, and in the robot's file.
    /// Otherwise it is not corrected, and the question is not asked again. The result is reported as a
    /// message. Errors: another station has the map, or by now there is another question.
    Result<void> answer(const ScannerQuestion& asked, bool correct);

private:
    ScannerAdvice m_advice;
    const StationScannersContext m_context;
    LiveMapping* m_mapping = nullptr;
};

}  // namespace leitstand
