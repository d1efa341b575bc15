#include "app/services/finds/evidence_reader.h"

#include <string>
#include <utility>

#include "app/services/finds/evidence_in_log.h"
#include "app/services/finds/freezing.h"
#include "app/services/log/event_decoder.h"
#include "app/services/log/log_entry.h"
#include "app/services/log/mission_robots.h"
#include "core/event/find_sample.h"
#include "core/event/picture_samples.h"
#include "core/io/bag/bag_reader.h"

namespace leitstand {
namespace {

constexpr std::size_t MostShown = 4;  ///< of a find

}  // namespace

EvidenceReader::EvidenceReader(std::filesystem::path mission, Answer answer)
    : m_mission(std::move(mission)),
      m_answer(std::move(answer)),
      m_thread([this](const std::stop_token& stop) { m_queue.work(stop); }) {}

void EvidenceReader::want(const FindSample& find) {
    m_queue.cancel();
    m_queue.submit([this, find](const std::stop_token& cancelled) {
        if (cancelled.stop_requested()) return;
        const ReadEvidence read = readEvidence(m_mission, find);
        if (!cancelled.stop_requested()) m_answer(find, read);
    });
}

ReadEvidence readEvidence(const std::filesystem::path& mission, const FindSample& find) {
    ReadEvidence read;
    auto bag = BagReader::open(mission);
    if (!bag) return read;
    std::vector<std::string> warnings;
    EventDecoder decoder(robotsOf(mission, **bag, warnings));
    for (const VictimEvidence& one : find.evidence) {
        if (!isPictureEvidence(one) || read.pictures.size() >= MostShown) continue;
        const std::uint64_t sequence = sequenceInLog(**bag, decoder, one, find);
        if (sequence > (*bag)->lastSequence()) read.written = false;
        const auto raw = sequence == 0 ? std::nullopt : (*bag)->event(sequence);
        if (!raw) continue;
        const auto event = decodedAlone(**bag, decoder, *raw);
        const auto* const sample = event ? event->sample.as<PictureSample>() : nullptr;
        if (sample == nullptr) continue;
        if (auto picture = evidencePicture(*sample, *event, decoder.robots()))
            read.pictures.push_back(std::move(picture).value());
    }
    return read;
}

}  // namespace leitstand
