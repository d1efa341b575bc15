#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace leitstand::simulation {

/// Keeps a world's time in step with the computer's clock. After a short interruption the world catches up;
/// time that is more than 0.2 s behind is skipped. A computer that is too slow first skips pictures, which
/// take most of its time. Everything else that a robot publishes and obeys keeps its rate.
class Pace {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds Step{5};
    static constexpr std::chrono::milliseconds MostBehind{200};
    /// If the world is further behind than this, few pictures are drawn.
    static constexpr std::chrono::milliseconds DrawsBehind{100};
    static constexpr int Few = 5;  ///< then only one picture in this many is drawn, per camera

    void begin(Clock::time_point now) { m_lived = now; }
    /// Returns whether a step of the world is due. If so, counts it as done.
    [[nodiscard]] bool step(Clock::time_point now);
    [[nodiscard]] Clock::time_point next() const { return m_lived + Step; }  ///< when a step is due
    /// Returns whether there is time to draw the picture of @p camera that is due. Each camera gets a share,
    /// independent of the rates of the others.
    [[nodiscard]] bool mayDraw(std::string_view camera, Clock::time_point now);

private:
    Clock::time_point m_lived;  ///< how far the world has advanced, on the computer's clock
    /// Number of consecutive pictures that were skipped, by camera.
    std::map<std::string, int, std::less<>> m_leftOut;
};

}  // namespace leitstand::simulation
