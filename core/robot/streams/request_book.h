#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "core/robot/link/link_status.h"
#include "core/robot/streams/stream_request.h"

namespace leitstand {

/// When requests for streams are sent.
struct RequestRhythm {
    /// Time between the first sends of a new request.
    std::chrono::nanoseconds again = std::chrono::seconds(1);
    int times = 3;                                                ///< number of those first sends
    std::chrono::nanoseconds reminder = std::chrono::seconds(5);  ///< time between later sends
};

/// A station's requests for the streams of one robot, and when to send them. The operator's requests are
/// combined with those for a thin link. A new request is sent at once and twice more. While it is in force it
/// is repeated every 5 s, for robots that restarted or missed it. Pure: no clock, no thread.
class RequestBook {
public:
    explicit RequestBook(const RequestRhythm& rhythm = {}) : m_rhythm(rhythm) {}

    /// Sets the operator's request for @p topic.
    void set(const std::string& topic, const StreamRequest& request);
    /// Replaces the requests for a thin link, by topic. Empty: the link is not thin.
    void setThin(const std::map<std::string, StreamRequest>& requests);
    /// Call when the robot has restarted. It knows of no requests, so all are sent again.
    void returned();

    [[nodiscard]] StreamRequest own(const std::string& topic) const;  ///< request of the operator
    /// Returns the stricter of the operator's request and that of the thin link.
    [[nodiscard]] StreamRequest effective(const std::string& topic) const;
    /// Returns what must be sent now; call it a few times a second.
    [[nodiscard]] std::vector<StreamCommandSample> due(SteadyTime now);

private:
    struct Entry {
        StreamRequest own, thin;
        int left = 0;          ///< number of first sends that are left
        SteadyTime next = {};  ///< not to be sent earlier
    };
    void change(Entry& entry, const StreamRequest& before);

    RequestRhythm m_rhythm;
    std::map<std::string, Entry> m_entries;
};

}  // namespace leitstand
