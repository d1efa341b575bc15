#pragma once

#include <chrono>
#include <cstddef>

namespace leitstand {

/// Estimates how many points can be drawn within the desired time of a frame. Learns from each frame.
class DetailBudget {
public:
    using Seconds = std::chrono::duration<double>;

    explicit DetailBudget(Seconds frameTime = Seconds(0.05), std::size_t firstGuess = 150'000)
        : m_frameTime(frameTime), m_points(firstGuess) {}

    [[nodiscard]] std::size_t points() const { return m_points; }
    /// Learns that drawing @p points took @p time. Frames with fewer points than the budget can only lower
    /// it.
    void drawn(std::size_t points, Seconds time);

    static constexpr std::size_t Least = 20'000, Most = 50'000'000;

private:
    Seconds m_frameTime;
    std::size_t m_points;
};

}  // namespace leitstand
