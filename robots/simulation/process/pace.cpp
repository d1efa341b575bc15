#include "robots/simulation/process/pace.h"

#include <algorithm>

namespace leitstand::simulation {

bool Pace::step(Clock::time_point now) {
    m_lived = std::max(m_lived, now - MostBehind);
    if (now - m_lived < Step) return false;
    m_lived += Step;
    return true;
}

bool Pace::mayDraw(Clock::time_point now) {
    const bool draw = now - m_lived <= DrawsBehind || m_leftOut + 1 >= Few;
    m_leftOut = draw ? 0 : m_leftOut + 1;
    return draw;
}

}  // namespace leitstand::simulation
