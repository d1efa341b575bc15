#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace leitstand::simulation {

/// Keeps a world's time with the computer's, in steps. After a hiccup it catches up; what is more than 0.2 s
/// behind is left out. A computer that is too slow leaves out pictures first, which take most of its time: so
/// whatever else a robot says and obeys keeps its rate.
class Pace {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds Step{5};
    static constexpr std::chrono::milliseconds MostBehind{200};
    static constexpr std::chrono::milliseconds DrawsBehind{100};  ///< further behind, few pictures are drawn
    static constexpr int Few = 5;                                 ///< one of so many of each camera

    void begin(Clock::time_point now) { m_lived = now; }
    /// Whether the world has to move on by a step, which then counts as done.
    [[nodiscard]] bool step(Clock::time_point now);
    [[nodiscard]] Clock::time_point next() const { return m_lived + Step; }  ///< when a step is due
    /// Whether there is time for the picture of @p camera that is due. Each camera has its share, whatever
    /// the others' rates.
    [[nodiscard]] bool mayDraw(std::string_view camera, Clock::time_point now);

private:
    Clock::time_point m_lived;                          ///< the world's time, by the computer's clock
    std::map<std::string, int, std::less<>> m_leftOut;  ///< pictures in a row, by camera
};

}  // namespace leitstand::simulation
