#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"

namespace leitstand {

struct RawEvent;
struct Event;

/// Samples of a topic that could not be decoded.
struct DecodingErrors {
    std::uint64_t count = 0;
    std::string last;  ///< text of the last error: topic, type and what was expected
};

/// Decodes received samples to events of core. Knows the robot and the role of each topic from the robots'
/// files. Ignores other topics, except those of stations. One thread at a time.
class EventDecoder {
public:
    explicit EventDecoder(std::vector<RobotDescription> robots);

    /// Calls @p take for each event decoded from @p event: usually one, but several on a topic that robots
    /// share ("/tf"). Does not call it when the topic is unknown or the sample is damaged.
    void decode(const RawEvent& event, const std::function<void(const Event&)>& take);
    /// Whether decode() can decode events on @p topic.
    [[nodiscard]] bool knows(const std::string& topic) const;
    /// Samples that could not be decoded so far, by topic.
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
