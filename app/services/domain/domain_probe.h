#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/services/domain/robot_guess.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/settings/domain_settings.h"

namespace leitstand {

/// A topic as the probe received it.
struct ProbedTopic {
    SeenTopic topic;
    int writers = 0, readers = 0;
    double rate = 0.0;  ///< samples a second
    double bytesPerSecond = 0.0;
    std::uint64_t lost = 0;  ///< by the sequence numbers of the writers
    std::string hosts;       ///< hosts that publish it (or subscribe to it, when nobody publishes)
};

/// What a domain contains.
struct ProbeReport {
    std::vector<ProbedTopic> topics;  ///< by name
    std::vector<RobotGuess> robots;   ///< guessed from the topics
    std::vector<std::string>
        warnings;          ///< about this computer, refused participants, packets that were dropped
    double seconds = 0.0;  ///< time spent listening [s]
};

/// Listens to a domain and reports its topics and what each is good for; publishes nothing.
class DomainProbe {
public:
    /// Joins the domain and leaves it when the probe is destroyed.
    [[nodiscard]] static Result<std::unique_ptr<DomainProbe>> open(const DomainSettings& settings);
    ~DomainProbe();
    DomainProbe(const DomainProbe&) = delete;
    DomainProbe& operator=(const DomainProbe&) = delete;

    /// Listens for @p seconds, or until @p progress is cancelled.
    [[nodiscard]] ProbeReport listen(double seconds, const Progress& progress = {});

private:
    struct State;
    explicit DomainProbe(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
