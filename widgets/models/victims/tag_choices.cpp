#include "widgets/models/victims/tag_choices.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

QStringList tagChoices(const MissionState& mission, const FindSample& find) {
    const Eigen::Vector3d here = positionInMap(mission, find);
    std::vector<std::pair<double, std::string>> read;  // how far, what
    const auto add = [&](const Eigen::Vector3d& place, const std::string& text) {
        if (!text.empty()) read.emplace_back((place - here).norm(), text);
    };
    for (const auto& [key, entry] : *mission.finds) {
        const bool code = key.first == FindSample::Kind::Code;
        if (code && entry.victim.status != FindSample::Status::Discarded)
            add(positionInMap(mission, entry.victim), entry.victim.tag);
    }
    for (const auto& [id, entry] : *mission.candidates) {
        if (entry.candidate.dismissed) continue;
        for (const Cue& cue : entry.candidate.cues) {
            if (cue.kind == "code") add(positionInMap(mission, entry.candidate), cue.text);
        }
    }
    std::sort(read.begin(), read.end());
    QStringList texts;
    for (const auto& [distance, text] : read) texts += QString::fromStdString(text);
    texts.removeDuplicates();
    return texts;
}

}  // namespace leitstand
