#pragma once

#include <filesystem>
#include <functional>
#include <thread>
#include <vector>

#include "app/services/finds/evidence_picture.h"
#include "app/services/job_queue.h"
#include "core/event/victim_sample.h"

namespace leitstand {

/// The pictures that a find's evidence names, read.
struct ReadEvidence {
    std::vector<EvidencePicture> pictures;
    bool written = true;  ///< false: the log has not all of them yet
};

/// Reads pictures of finds out of a mission's log, which may be recorded meanwhile, on a thread of its own.
class EvidenceReader {
public:
    using Answer = std::function<void(const VictimSample& find, const ReadEvidence& read)>;

    /// @p answer is called on the reader's thread.
    EvidenceReader(std::filesystem::path mission, Answer answer);
    /// Reads the pictures of @p find; those of one that was asked for before are not wanted any more.
    void want(const VictimSample& find);

private:
    const std::filesystem::path m_mission;
    const Answer m_answer;
    JobQueue m_queue;
    std::jthread m_thread;  ///< last: joined first
};

/// The first four pictures of @p find in the log @p mission; what cannot be read is left out.
[[nodiscard]] ReadEvidence readEvidence(const std::filesystem::path& mission, const VictimSample& find);

}  // namespace leitstand
