#include "robots/simulation/process/pace.h"

#include <algorithm>

namespace leitstand::simulation {

bool Pace::step(Clock::time_point now) {
    m_lived = std::max(m_lived, now - MostBehind);
    if (now - m_lived < Step) return false;
    m_lived += Step;
    return true;
}

bool Pace::mayDraw(std::string_view camera, Clock::time_point now) {
    int& leftOut = m_leftOut.try_emplace(std::string(camera)).first->second;
    const bool draw = now - m_lived <= DrawsBehind || leftOut + 1 >= Few;
    leftOut = draw ? 0 : leftOut + 1;
    return draw;
}

}  // namespace leitstand::simulation
