#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <fastdds/dds/core/condition/GuardCondition.hpp>
#include <fastdds/dds/core/condition/WaitSet.hpp>

namespace leitstand::detail {

class Reader;

/// A thread that waits for samples of its readers and calls their callbacks, one after the other.
class LaneThread {
public:
    /// @p onWake is called on this thread after each wake().
    LaneThread(std::string threadName, std::function<void()> onWake = {});
    ~LaneThread();
    LaneThread(const LaneThread&) = delete;
    LaneThread& operator=(const LaneThread&) = delete;

    void add(const std::shared_ptr<Reader>& reader);
    /// Only forgets @p reader. Reader::close() ends its callbacks.
    void remove(const Reader& reader);
    void wake();  ///< may be called from any thread, also from listeners of Fast DDS
    void stop();  ///< ends the thread; waits for a running callback, so it must not be called from a callback

private:
    using Readers = std::vector<std::shared_ptr<Reader>>;
    void run();
    [[nodiscard]] Readers readers() const;
    [[nodiscard]] bool serve(const Readers& readers, const eprosima::fastdds::dds::ConditionSeq& active);

    std::function<void()> m_onWake;
    mutable std::mutex m_mutex;
    Readers m_readers;
    eprosima::fastdds::dds::GuardCondition m_guard;
    eprosima::fastdds::dds::WaitSet m_waitSet;
    std::atomic<bool> m_stop = false;
    std::jthread m_thread;  // last member: joined first
};

}  // namespace leitstand::detail
