#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace leitstand::simulation {

/// Keeps a world's time in step with the computer's clock. After a hiccup the world catches up; time that is
/// more than 0.2 s behind is skipped. A computer that is too slow skips pictures first, which take most of
/// its time. All else that a robot publishes and obeys keeps its rate.
class Pace {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds Step{5};
    static constexpr std::chrono::milliseconds MostBehind{200};
    static constexpr std::chrono::milliseconds DrawsBehind{100};  ///< further behind, few pictures are drawn
    static constexpr int Few = 5;                                 ///< then one in so many per camera is drawn

    void begin(Clock::time_point now) { m_lived = now; }
    /// Returns whether a step of the world is due, and counts it as done.
    [[nodiscard]] bool step(Clock::time_point now);
    [[nodiscard]] Clock::time_point next() const { return m_lived + Step; }  ///< when a step is due
    /// Returns whether there is time to draw the due picture of @p camera. Each camera has its share,
    /// whatever the rates of the others.
    [[nodiscard]] bool mayDraw(std::string_view camera, Clock::time_point now);

private:
    Clock::time_point m_lived;                          ///< the world's time, by the computer's clock
    std::map<std::string, int, std::less<>> m_leftOut;  ///< pictures skipped in a row, by camera
};

}  // namespace leitstand::simulation
