#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/services/domain/seen_topic.h"
#include "app/services/topics/message_inspector.h"
#include "app/services/topics/type_asker.h"
#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "transport/dds/node.h"

namespace leitstand {

/// What came on the topic that is watched.
struct TopicView {
    std::string topic, type;
    std::uint64_t messages = 0;  ///< since it is watched
    double rate = 0.0;           ///< over the last 5 s [Hz]
    double megabits = 0.0;       ///< over the last 5 s [Mbit/s]
    std::optional<double> age;   ///< of the newest message [s]; empty: none came
    std::optional<InspectedMessage> newest;
    std::string problem;  ///< why `newest` is empty: the type's text is not known, ...
};

/// Watches one topic of the domain that an engineer looks at, beside all that the station records: it
/// subscribes as long as somebody looks. Any thread.
class TopicWatch {
public:
    explicit TopicWatch(Node& node) : m_node(node), m_types(node) {}

    /// Watches @p topic instead of the one before. Error: it cannot be subscribed.
    Result<void> watch(const SeenTopic& topic);
    void end();
    /// Empty: nothing is watched.
    [[nodiscard]] std::optional<TopicView> view() const;

    /// Keeps the numbers of the field at @p path of each message from now on; empty: of none.
    void plot(const std::string& path);
    static constexpr double PlotSpan = 60.0;  ///< [s]
    /// The numbers that were kept, oldest first, with their ages [s].
    [[nodiscard]] std::vector<std::pair<double, double>> plotted() const;

private:
    /// Shared with the callback, which may outlast a subscription.
    struct Watched {
        std::mutex mutex;
        std::string topic, type;
        SeenTopic seen;       ///< what is watched
        MessageTextPtr text;  ///< null: not known yet, or at all
        std::string problem;
        bool hindered = false;  ///< whether nothing can come
        SteadyTime since = steadyNow();
        Payload newest;
        std::uint64_t messages = 0;
        std::deque<std::pair<SteadyTime, std::size_t>>
            received;      ///< of the last seconds: when, how many bytes
        std::string path;  ///< of the field that is plotted
        std::deque<std::pair<SteadyTime, double>> numbers;
        std::mutex looking;  ///< guards the two that follow; taken without the other one
        Payload shown;       ///< what `inspected` was read from
        std::optional<Result<InspectedMessage>> inspected;
    };
    static void take(Watched& watched, const ReceivedSample& sample);

    void learn(Watched& watched) const;

    Node& m_node;
    mutable TypeAsker m_types;
    mutable std::mutex m_mutex;  ///< guards the two that follow
    std::shared_ptr<Watched> m_watched;
    std::unique_ptr<Subscription> m_subscription;
};

}  // namespace leitstand
