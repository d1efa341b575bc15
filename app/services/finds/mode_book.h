#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/event/event.h"

namespace leitstand {

/// Remembers which robot drove itself when: whether a find counts as autonomous is decided when it is seen,
/// not when its place is worked out. Any thread.
class ModeBook {
public:
    void onEvent(const Event& event);  ///< modes; others are passed by
    /// Whether @p robot drove itself at @p moment (station's clock); empty: nobody said.
    [[nodiscard]] std::optional<bool> autonomousAt(const std::string& robot, Time moment) const;

private:
    using Modes = std::map<Time, bool>;  ///< from when on it drives itself, or does not
    [[nodiscard]] static std::optional<bool> at(const Modes& modes, Time moment);

    mutable std::mutex m_mutex;
    std::map<std::string, Modes> m_modes;  ///< by robot; changes alone
};

}  // namespace leitstand
