#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/time.h"

namespace leitstand {

struct Event;

/// Records when robots drove by themselves. Whether a find counts as autonomous is decided by the moment when
/// it was seen, not when its place was computed. Any thread.
class ModeBook {
public:
    void onEvent(const Event& event);  ///< takes modes; ignores others
    /// Whether @p robot drove itself at @p moment (station's clock); empty: unknown.
    [[nodiscard]] std::optional<bool> autonomousAt(const std::string& robot, Time moment) const;

private:
    using Modes = std::map<Time, bool>;  ///< whether the robot drives by itself, by the time since when
    [[nodiscard]] static std::optional<bool> at(const Modes& modes, Time moment);

    mutable std::mutex m_mutex;
    std::map<std::string, Modes> m_modes;  ///< by robot; changes only
};

}  // namespace leitstand
