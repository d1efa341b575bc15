#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "core/robot/link/link_status.h"
#include "core/robot/streams/stream_wish.h"

namespace leitstand {

/// When wishes are said.
struct WishRhythm {
    std::chrono::nanoseconds again = std::chrono::seconds(1);     ///< a new one, the first times
    int times = 3;                                                ///< ... so often
    std::chrono::nanoseconds reminder = std::chrono::seconds(5);  ///< what is not as the robot likes
};

/// What a station wants of the streams of one robot, and when that has to be said: the operator's own wishes,
/// and on top of them those of a thin link. A new wish is said at once and twice more; as long as it stands,
/// every 5 s, so that a robot that starts again or missed it follows too. Pure: no clock, no thread.
class WishBook {
public:
    explicit WishBook(const WishRhythm& rhythm = {}) : m_rhythm(rhythm) {}

    /// The operator's wish for @p topic.
    void set(const std::string& topic, const StreamWish& wish);
    /// What a thin link asks for, by topic; replaces what it asked before. Empty: the link is not thin.
    void setThin(const std::map<std::string, StreamWish>& wishes);
    /// The robot was there anew: it knows nothing of any wish.
    void returned();

    [[nodiscard]] StreamWish own(const std::string& topic) const;        ///< of the operator
    [[nodiscard]] StreamWish effective(const std::string& topic) const;  ///< with the thin link
    /// What has to be said now; to be asked a few times a second.
    [[nodiscard]] std::vector<StreamCommandSample> due(SteadyTime now);

private:
    struct Entry {
        StreamWish own, thin;
        int left = 0;          ///< times that it is said in short order
        SteadyTime next = {};  ///< not before
    };
    void change(Entry& entry, const StreamWish& before);

    WishRhythm m_rhythm;
    std::map<std::string, Entry> m_entries;
};

}  // namespace leitstand
