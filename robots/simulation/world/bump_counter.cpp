#include "robots/simulation/world/bump_counter.h"

#include <chrono>

namespace leitstand::simulation {
namespace {

constexpr std::chrono::milliseconds Released{500};

}  // namespace

bool BumpCounter::isNew(const Obstacle& obstacle, Time now) {
    std::erase_if(m_contacts, [&](const Contact& contact) { return now - contact.last > Released; });
    bool known = false, listed = false;
    for (Contact& contact : m_contacts) {
        const bool sameThing = contact.element == obstacle.element && contact.body == obstacle.body &&
                               contact.victim == obstacle.victim;
        const bool sameWall = !obstacle.victim && !contact.victim && obstacle.body < 0 && contact.body < 0 &&
                              contact.normal.dot(obstacle.normalInArena) > 0.7;
        if (!sameThing && !sameWall) continue;
        contact.last = now;
        known = true;
        listed = listed || sameThing;
    }
    // A wall that faces the same way as a touched one is also listed itself, for when the robot slides on.
    if (!listed) {
        m_contacts.push_back({obstacle.element, obstacle.body, obstacle.victim, obstacle.normalInArena, now});
    }
    return !known;
}

}  // namespace leitstand::simulation
