#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/robot/control/stop/stop_status.h"
#include "core/robot/services/service_description.h"

namespace leitstand {

/// Times for services that have a part in a stop.
struct ServiceStopTiming {
    /// Between repeats, until the service answers.
    std::chrono::nanoseconds repeat = std::chrono::milliseconds(250);
    /// Between repeats of a stop that was refused.
    std::chrono::nanoseconds refused = std::chrono::seconds(1);
    /// An unanswered release is revoked after this long.
    std::chrono::nanoseconds release = std::chrono::seconds(2);
};

/// The part of one service in the stop of a robot, such as an e-stop or the cancelling of goals. Pure.
///
/// A stop is repeated until the service confirms it, however long that takes, and again for a server that
/// started anew. A release that is refused or unanswered for 2 s is revoked: the service is asked to stop
/// again. So it does not release the robot unexpectedly when the link returns.
class ServiceStop {
public:
    explicit ServiceStop(ServiceDescription service, const ServiceStopTiming& timing = {});

    void stop(SteadyTime now);
    /// Does nothing unless a stop is in force. Nobody is waited for if nobody offers the service.
    void release(SteadyTime now);
    /// Takes whether anybody offers the service; @p anew: whether somebody else than before.
    void offered(bool offered, bool anew, SteadyTime now);

    /// A call to be made; answered() wants its tag.
    struct Call {
        std::uint64_t tag = 0;
        ServiceRequest request;
    };
    [[nodiscard]] std::optional<Call> due(SteadyTime now);
    /// Takes the answer to a call. Ignores answers to calls that something newer was asked after.
    void answered(std::uint64_t tag, const ServiceAnswer& answer, SteadyTime now);
    /// Returns once whether a release was revoked, so that the rest of the robot must be stopped again, too.
    [[nodiscard]] bool takeRevoked();

    /// Why the last release was revoked, kept until the next stop() or release(); empty: it was not.
    [[nodiscard]] const std::string& refusal() const { return m_refusal; }
    [[nodiscard]] bool isReleasing() const { return m_stage == StopServiceStatus::Stage::Releasing; }
    [[nodiscard]] StopServiceStatus status() const;

private:
    using Stage = StopServiceStatus::Stage;
    void enter(Stage stage, SteadyTime now);
    void revoke(std::string why, SteadyTime now);
    [[nodiscard]] const std::string& title() const;

    ServiceDescription m_service;
    ServiceStopTiming m_timing;
    std::optional<ServiceRequest> m_stop, m_release;
    Stage m_stage = Stage::Idle;
    SteadyTime m_since = {}, m_next = {};  ///< when the stage began; when to call next
    std::uint64_t m_tag = 0, m_older = 0;  ///< of the newest call; of the newest call of another stage
    bool m_offered = false, m_refused = false, m_revoked = false;
    std::string m_message, m_refusal;
};

}  // namespace leitstand
