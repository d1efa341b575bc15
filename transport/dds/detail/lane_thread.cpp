#include "transport/dds/detail/lane_thread.h"

#include <algorithm>
#include <cassert>

#include <pthread.h>

#include "transport/dds/detail/fastdds.h"
#include "transport/dds/detail/reader.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;
constexpr int SamplesInTurn = 32;  // of one reader before the next has its turn

}  // namespace

LaneThread::LaneThread(std::string threadName, std::function<void()> onWake) : m_onWake(std::move(onWake)) {
    m_waitSet.attach_condition(m_guard);
    m_thread = std::jthread([this, name = std::move(threadName)] {
        pthread_setname_np(pthread_self(), name.c_str());
        run();
    });
}

LaneThread::~LaneThread() {
    stop();
    m_waitSet.detach_condition(m_guard);
}

void LaneThread::stop() {
    m_stop = true;
    wake();
    assert(m_thread.get_id() != std::this_thread::get_id());
    if (m_thread.joinable()) m_thread.join();
}

void LaneThread::add(const std::shared_ptr<Reader>& reader) {
    {
        const std::scoped_lock lock(m_mutex);
        if (std::find(m_readers.begin(), m_readers.end(), reader) == m_readers.end())
            m_readers.push_back(reader);
    }
    m_waitSet.attach_condition(reader->condition());
}

void LaneThread::remove(const Reader& reader) {
    m_waitSet.detach_condition(reader.condition());
    const std::scoped_lock lock(m_mutex);
    std::erase_if(m_readers, [&](const auto& one) { return one.get() == &reader; });
}

void LaneThread::wake() {
    m_guard.set_trigger_value(true);
}

LaneThread::Readers LaneThread::readers() const {
    const std::scoped_lock lock(m_mutex);
    return m_readers;
}

bool LaneThread::serve(const Readers& readers, const efd::ConditionSeq& active) {
    bool more = false;
    for (const auto& reader : readers) {
        // Conditions are compared, never dereferenced: a reader may be gone when the wait set returns.
        const bool due = reader->unfinished ||
                         std::any_of(active.begin(), active.end(),
                                     [&](const auto* one) { return one == reader->conditionAddress(); });
        reader->unfinished = due;
        for (int i = 0; i < SamplesInTurn && reader->unfinished && !m_stop; ++i) {
            reader->unfinished = reader->deliver();
        }
        more = more || reader->unfinished;
    }
    return more;
}

void LaneThread::run() {
    efd::ConditionSeq active;
    bool more = false;
    while (!m_stop) {
        const auto patience = more ? fastdds::Zero : fastdds::Infinite;
        active.clear();
        m_waitSet.wait(active, patience);
        if (m_stop) return;
        if (m_guard.get_trigger_value()) {
            m_guard.set_trigger_value(false);
            if (m_onWake) m_onWake();
        }
        more = serve(readers(), active);
    }
}

}  // namespace leitstand::detail
