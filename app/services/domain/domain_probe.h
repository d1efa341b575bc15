#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/services/domain/domain_settings.h"
#include "app/services/domain/robot_guess.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace leitstand {

/// A topic as it was heard.
struct ProbedTopic {
    SeenTopic topic;
    int writers = 0, readers = 0;
    double rate = 0.0;  ///< samples a second
    double bytesPerSecond = 0.0;
    std::uint64_t lost = 0;  ///< by the writers' numbers
    std::string hosts;       ///< who writes it (or reads it, when nobody does)
};

/// What a domain holds.
struct ProbeReport {
    std::vector<ProbedTopic> topics;  ///< by name
    std::vector<RobotGuess> robots;   ///< what they are good for
    std::vector<std::string>
        warnings;          ///< about this computer, refused participants, packets that were dropped
    double seconds = 0.0;  ///< listened
};

/// Listens to a domain and tells what is there and what it is good for; says nothing to anybody.
class DomainProbe {
public:
    /// Joins the domain, which is left when the probe goes.
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
