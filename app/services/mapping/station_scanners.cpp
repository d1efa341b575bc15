#include "app/services/mapping/station_scanners.h"

#include <utility>

#include "app/services/mapping/live_mapping.h"
#include "app/services/mapping/mapping_text.h"
#include "core/base/words.h"
#include "core/event/stream_role.h"

namespace leitstand {

StationScanners::StationScanners(std::vector<RobotDescription> robots, std::filesystem::path mission,
                                 StationScannersContext context)
    : m_advice(std::move(robots), std::move(mission)), m_context(std::move(context)) {}

void StationScanners::listen(LiveMappingListener& listener) {
    listener.onScanner = [this](const std::string& robot, const ScannerFinding& finding) {
        if (m_advice.follow(robot, finding))
            m_context.notify(mapping_words::scannerIsOff(m_context.titleOf(robot)));
    };
    listener.onMapsWith = [this](const std::string& robot, const std::string& topic) {
        const auto kept = m_advice.mapWith(robot, topic);
        const std::string title = m_context.titleOf(robot);
        const bool plane = m_advice.mappingRole(robot, topic) == StreamRole::Ranges;
        m_context.notify(plane ? mapping_words::mapsByLaser(title, topic)
                               : mapping_words::mapsWith(title, topic));
        if (!kept) m_context.notify(kept.error().text);
    };
}

std::optional<ScannerQuestion> StationScanners::question() const {
    return m_context.granted() ? m_advice.question() : std::nullopt;
}

Result<void> StationScanners::answer(const ScannerQuestion& asked, bool correct) {
    if (auto may = m_context.granted(); !may) return may;
    const auto question = m_advice.question();
    if (!question || !question->asksAs(asked))
        return Error{translate("leitstand::Station", "nothing is asked about the scanner any more")};
    if (!correct) {
        m_advice.leave(asked);
        m_mapping->leaveAsIs(asked.robot, faultOf(asked.more));
        return {};
    }
    const ScannerAdvice::Used used = m_advice.use(asked);
    m_mapping->correct(asked.robot, used.total);
    m_context.notify(mapping_words::scannerCorrected(m_context.titleOf(asked.robot), used.file));
    if (!used.notWritten.empty()) m_context.notify(used.notWritten);
    return {};
}

Result<void> StationScanners::mapWith(const std::string& robot, const std::string& topic) {
    if (auto may = m_context.granted(); !may) return may;
    if (!m_advice.mappingRole(robot, topic))
        return Error{leitstand::fill(
            translate("leitstand::Station", "{}: expected a topic of its scanners, found {}"), robot, topic)};
    m_mapping->mapWith(robot, topic);
    return {};
}

std::string StationScanners::mapsWith(const std::string& robot) const {
    return m_advice.mapsWith(robot);
}

}  // namespace leitstand
