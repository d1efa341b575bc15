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
    std::chrono::nanoseconds again = std::chrono::seconds(1);  ///< between the first sends of a new request
    int times = 3;                                             ///< number of those first sends
    std::chrono::nanoseconds reminder = std::chrono::seconds(5);  ///< between later sends
};

/// A station's requests for the streams of one robot, and when to send them. The operator's own requests are
/// combined with those of a thin link. A new request is sent at once and twice more. While it is in force it
/// is sent every 5 s, so that a robot that restarted or missed it follows too. Pure: no clock, no thread.
class RequestBook {
public:
    explicit RequestBook(const RequestRhythm& rhythm = {}) : m_rhythm(rhythm) {}

    /// Sets the operator's request for @p topic.
    void set(const std::string& topic, const StreamRequest& request);
    /// Sets the requests of a thin link, by topic, in place of all earlier ones. Empty: the link is not thin.
    void setThin(const std::map<std::string, StreamRequest>& requests);
    /// Call when the robot came back, since it knows of no request: all are sent again.
    void returned();

    [[nodiscard]] StreamRequest own(const std::string& topic) const;  ///< request of the operator
    /// Returns the stricter of the operator's request and that of the thin link.
    [[nodiscard]] StreamRequest effective(const std::string& topic) const;
    /// Returns what must be sent now; call it a few times a second.
    [[nodiscard]] std::vector<StreamCommandSample> due(SteadyTime now);

private:
    struct Entry {
        StreamRequest own, thin;
        int left = 0;          ///< number of first sends that remain
        SteadyTime next = {};  ///< not before
    };
    void change(Entry& entry, const StreamRequest& before);

    RequestRhythm m_rhythm;
    std::map<std::string, Entry> m_entries;
};

}  // namespace leitstand
