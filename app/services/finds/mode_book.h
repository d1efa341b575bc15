#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/time.h"

namespace leitstand {

struct Event;

/// Records when robots drove by themselves. A find is autonomous if the robot drove itself when it was seen,
/// not when its place was computed. Any thread.
class ModeBook {
public:
    void onEvent(const Event& event);  ///< takes modes; ignores other events
    /// Whether @p robot drove itself at @p moment (station's clock); empty: unknown.
    [[nodiscard]] std::optional<bool> autonomousAt(const std::string& robot, Time moment) const;

private:
    using Modes = std::map<Time, bool>;  ///< whether the robot drives by itself since each time
    [[nodiscard]] static std::optional<bool> at(const Modes& modes, Time moment);

    mutable std::mutex m_mutex;
    std::map<std::string, Modes> m_modes;  ///< by robot; only changes are stored
};

}  // namespace leitstand
