#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/mission/event.h"
#include "core/mission/finds/find_book.h"

namespace leitstand {

/// Remembers which robot drove itself when, and what the mode was when candidates were told first: whether a
/// find counts as autonomous is decided then, not when somebody files it. Any thread.
class FirstToldBook {
public:
    void take(const Event& event);             ///< modes and candidates; others are passed by
    void toldBefore(std::uint32_t candidate);  ///< in an earlier session: what the mode was then is not known
    /// Empty: it was told before this book began.
    [[nodiscard]] std::optional<FirstTold> of(std::uint32_t candidate) const;
    /// Whether @p robot drove itself at @p moment (station's clock); empty: nobody said.
    [[nodiscard]] std::optional<bool> autonomousAt(const std::string& robot, Time moment) const;

private:
    using Modes = std::map<Time, bool>;  ///< from when on it drives itself, or does not
    [[nodiscard]] static std::optional<bool> at(const Modes& modes, Time moment);

    mutable std::mutex m_mutex;
    std::map<std::string, Modes> m_modes;  ///< by robot; changes alone
    std::map<std::uint32_t, std::optional<FirstTold>> m_first;
};

}  // namespace leitstand
