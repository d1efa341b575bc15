#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/control/stop/guard_rules.h"
#include "transport/dds/node.h"
#include "transport/link/drive_message.h"

namespace leitstand {

/// Words that a guard sends to its station through the pipe, at each change and twice a second. Ready: the
/// robot receives the guard's commands. Waits: it does not.
namespace guard_word {
inline constexpr std::string_view Ready = "ready", Waits = "waits";
}

struct DriveGuardSettings {
    std::string ownName = "leitstand-guard";  ///< name of the guard's node
    std::string robot;                        ///< name of the robot
    std::string station;                      ///< identity of the station that is guarded
    Sender driver = {};    ///< process of that station, which is not treated as another driver
    DriveMessage message;  ///< how the robot is driven
    GuardTiming timing = {};
};

/// Sends zeros to a robot when the station that drives it hangs or dies (GuardRules). Runs in a separate
/// process, takes part in the domain by itself, and receives grants and the drive commands of others.
class DriveGuard {
public:
    /// Errors: the drive message cannot be encoded, or the node may not use the topics.
    [[nodiscard]] static Result<std::unique_ptr<DriveGuard>> create(Node& node, DriveGuardSettings settings);
    ~DriveGuard();
    DriveGuard(const DriveGuard&) = delete;
    DriveGuard& operator=(const DriveGuard&) = delete;

    /// Guards until the station's end of @p pipe is closed and nothing is left to do. @p pipe: a socket that
    /// keeps message boundaries (SOCK_SEQPACKET). It receives GuardPulse and sends guard_word.
    void serve(int pipe);

private:
    struct State;
    explicit DriveGuard(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
