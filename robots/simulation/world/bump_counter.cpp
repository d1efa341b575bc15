#include "robots/simulation/world/bump_counter.h"

#include <algorithm>
#include <chrono>

namespace leitstand::simulation {
namespace {

constexpr std::chrono::milliseconds Released{500};

}  // namespace

bool BumpCounter::isNew(const Obstacle& obstacle, bool victim, Time now) {
    std::erase_if(m_contacts, [&](const Contact& contact) { return now - contact.last > Released; });
    bool known = false;
    for (Contact& contact : m_contacts) {
        const bool sameThing = contact.element == obstacle.element && contact.body == obstacle.body;
        const bool sameWall = !victim && !contact.victim && obstacle.body < 0 && contact.body < 0 &&
                              contact.normal.dot(obstacle.normalInArena) > 0.7;
        if (!sameThing && !sameWall) continue;
        contact.last = now;
        known = true;
    }
    // A wall that faces as another touched one is remembered by its own name too, for when the robot slides
    // on.
    const bool listed = std::any_of(m_contacts.begin(), m_contacts.end(), [&](const Contact& contact) {
        return contact.element == obstacle.element && contact.body == obstacle.body;
    });
    if (!listed) m_contacts.push_back({obstacle.element, obstacle.body, victim, obstacle.normalInArena, now});
    return !known;
}

}  // namespace leitstand::simulation
