#pragma once

#include <filesystem>
#include <functional>
#include <thread>
#include <vector>

#include "app/services/finds/evidence_picture.h"
#include "app/services/job_queue.h"

namespace leitstand {

struct FindSample;

/// The pictures in a find's evidence, after they were read.
struct ReadEvidence {
    std::vector<EvidencePicture> pictures;
    bool written = true;  ///< whether the log has all of them already
};

/// Reads pictures of finds from a mission's log on its own thread. The mission may still be running.
class EvidenceReader {
public:
    using Answer = std::function<void(const FindSample& find, const ReadEvidence& read)>;

    /// @p answer is called on the reader's thread.
    EvidenceReader(std::filesystem::path mission, Answer answer);
    /// Requests the pictures of @p find. Cancels any earlier request.
    void want(const FindSample& find);

private:
    const std::filesystem::path m_mission;
    const Answer m_answer;
    JobQueue m_queue;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

/// Reads the first four pictures of @p find from the log @p mission; leaves out what cannot be read.
[[nodiscard]] ReadEvidence readEvidence(const std::filesystem::path& mission, const FindSample& find);

}  // namespace leitstand
