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

/// A topic, and what the probe received on it.
struct ProbedTopic {
    SeenTopic topic;
    int writers = 0, readers = 0;
    double rate = 0.0;  ///< samples per second
    double bytesPerSecond = 0.0;
    std::uint64_t lost = 0;  ///< number of lost samples, from the writers' sequence numbers
    std::string hosts;       ///< hosts that publish it; if nobody does, hosts that subscribe to it
};

/// What a domain contains.
struct ProbeReport {
    std::vector<ProbedTopic> topics;    ///< by name
    std::vector<RobotGuess> robots;     ///< guessed from the topics
    std::vector<std::string> warnings;  ///< about this computer, refused participants, and dropped packets
    double seconds = 0.0;               ///< time spent listening [s]
};

/// Listens to a domain, and reports its topics and what each can be used for. Publishes nothing.
class DomainProbe {
public:
    /// Joins the domain. The domain is left when the probe is destroyed.
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
