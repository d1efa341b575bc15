#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What could not be decoded of a topic.
struct DecodingErrors {
    std::uint64_t count = 0;
    std::string last;  ///< names topic, type and expectation
};

/// Turns what was received into core's own events: knows which robot and which role a topic has. Topics that
/// nobody listed are none of its business. One thread at a time.
class EventDecoder {
public:
    explicit EventDecoder(std::vector<RobotDescription> robots);

    /// Calls @p take for what @p event says: once, not at all when nobody knows the topic or it is broken,
    /// several times on a topic that robots share ("/tf").
    void decode(const RawEvent& event, const std::function<void(const Event&)>& take);
    /// Whether decode() may have something to say of @p topic.
    [[nodiscard]] bool knows(const std::string& topic) const;
    /// What was broken so far, by topic.
    [[nodiscard]] const std::map<std::string, DecodingErrors>& errors() const { return m_errors; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_robots; }

private:
    struct Listing {
        std::size_t robot, stream;
    };
    void complain(const std::string& topic, const std::string& text);

    std::vector<RobotDescription> m_robots;
    std::multimap<std::string, Listing> m_listings;  ///< by topic
    std::map<std::string, DecodingErrors> m_errors;
};

}  // namespace leitstand
