#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "core/robot/link/link_status.h"
#include "core/robot/streams/stream_request.h"

namespace leitstand {

/// When wishes are sent.
struct RequestRhythm {
    std::chrono::nanoseconds again = std::chrono::seconds(1);     ///< between the first times of a new one
    int times = 3;                                                ///< number of those first times
    std::chrono::nanoseconds reminder = std::chrono::seconds(5);  ///< for wishes in force
};

/// A station's wishes for the streams of one robot, and when to send them. The operator's own wishes are
/// combined with those of a thin link. A new wish is sent at once and twice more. While it is in force it is
/// sent every 5 s, so that a robot that restarts or missed it follows too. Pure: no clock, no thread.
class RequestBook {
public:
    explicit RequestBook(const RequestRhythm& rhythm = {}) : m_rhythm(rhythm) {}

    /// Sets the operator's wish for @p topic.
    void set(const std::string& topic, const StreamRequest& request);
    /// Sets the wishes of a thin link, by topic, in place of its earlier ones. Empty: the link is not thin.
    void setThin(const std::map<std::string, StreamRequest>& requests);
    /// The robot came back and knows of no wish.
    void returned();

    [[nodiscard]] StreamRequest own(const std::string& topic) const;        ///< of the operator
    [[nodiscard]] StreamRequest effective(const std::string& topic) const;  ///< with the thin link
    /// Returns what must be sent now; call it a few times a second.
    [[nodiscard]] std::vector<StreamCommandSample> due(SteadyTime now);

private:
    struct Entry {
        StreamRequest own, thin;
        int left = 0;          ///< remaining sends in short order
        SteadyTime next = {};  ///< not before
    };
    void change(Entry& entry, const StreamRequest& before);

    RequestRhythm m_rhythm;
    std::map<std::string, Entry> m_entries;
};

}  // namespace leitstand
