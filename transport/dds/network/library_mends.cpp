#include "transport/dds/network/library_mends.h"

#include <atomic>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

#include <dlfcn.h>

#include "transport/dds/detail/fastdds.h"

#if LEITSTAND_FASTDDS_3
#define LEITSTAND_RTPS_NAMESPACE "8eprosima7fastdds4rtps"
#else
#define LEITSTAND_RTPS_NAMESPACE "8eprosima8fastrtps4rtps"
#endif
// The library's functions as the compiler names them.
/// bool SecurityManager::encode_rtps_message(const CDRMessage_t&, CDRMessage_t&, const
/// std::vector<GuidPrefix_t>&) const
#define LEITSTAND_ENCODE                                                                                \
    "_ZNK" LEITSTAND_RTPS_NAMESPACE                                                                     \
    "8security15SecurityManager19encode_rtps_messageERKNS1_12CDRMessage_tERS4_RKSt6vectorINS1_12GuidPr" \
    "efix_tESaIS9_EE"
/// bool StatefulWriter::matched_reader_remove(const GUID_t&)
#define LEITSTAND_REMOVE_READER \
    "_ZN" LEITSTAND_RTPS_NAMESPACE "14StatefulWriter21matched_reader_removeERKNS1_6GUID_tE"
/// void StatefulWriter::check_acked_status()
#define LEITSTAND_CHECK_ACKED "_ZN" LEITSTAND_RTPS_NAMESPACE "14StatefulWriter18check_acked_statusEv"

namespace leitstand::detail {
namespace {

using Audience = std::vector<fastdds::rtps::GuidPrefix_t>;

template <class Function>
Function* librarysOwn(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Writers that readers are being removed from. Meanwhile nobody checks them: a flow controller's thread that
/// finds no reader left would take its own lock a second time. The thread that removes the reader checks when
/// the list is free again, until nobody has asked for a check meanwhile.
class Removals {
public:
    void begin(void* writer) {
        const std::lock_guard lock(m_mutex);
        ++m_writers[writer].removing;
        m_any.fetch_add(1);
    }
    /// Returns whether the check of @p writer is put off, and records that it was asked for.
    [[nodiscard]] bool putsOff(void* writer) {
        if (m_any.load() == 0) return false;
        const std::lock_guard lock(m_mutex);
        const auto found = m_writers.find(writer);
        if (found == m_writers.end()) return false;
        found->second.asked = true;
        return true;
    }
    /// Ends a removal; runs @p check when a check was put off.
    template <class Check>
    void end(void* writer, const Check& check) {
        std::unique_lock lock(m_mutex);
        auto& removal = m_writers[writer];
        while (removal.removing == 1 && std::exchange(removal.asked, false)) {
            lock.unlock();
            check(writer);
            lock.lock();
        }
        if (--removal.removing == 0) m_writers.erase(writer);
        m_any.fetch_sub(1);
    }

private:
    struct Removal {
        int removing = 0;  ///< number of threads
        bool asked = false;
    };
    std::mutex m_mutex;
    std::unordered_map<void*, Removal> m_writers;
    std::atomic<int> m_any = 0;
};

Removals& removals() {
    static auto* const all = new Removals;  // threads of the library may outlive static objects
    return *all;
}

}  // namespace

extern "C" {

[[gnu::used, gnu::visibility("default")]] bool leitstandEncode(
    const void* manager, const void* plain, void* encoded,
    const Audience& audience) __asm__(LEITSTAND_ENCODE);
[[gnu::used, gnu::visibility("default")]] bool leitstandRemoveReader(
    void* writer, const void* reader) __asm__(LEITSTAND_REMOVE_READER);
[[gnu::used, gnu::visibility("default")]] void leitstandCheckAcked(void* writer) __asm__(
    LEITSTAND_CHECK_ACKED);

bool leitstandEncode(const void* manager, const void* plain, void* encoded, const Audience& audience) {
    static auto* const encode = librarysOwn<decltype(leitstandEncode)>(LEITSTAND_ENCODE);
    return !audience.empty() && encode(manager, plain, encoded, audience);
}

bool leitstandRemoveReader(void* writer, const void* reader) {
    static auto* const remove = librarysOwn<decltype(leitstandRemoveReader)>(LEITSTAND_REMOVE_READER);
    static auto* const check = librarysOwn<decltype(leitstandCheckAcked)>(LEITSTAND_CHECK_ACKED);
    removals().begin(writer);
    const bool removed = remove(writer, reader);
    removals().end(writer, check);
    return removed;
}

void leitstandCheckAcked(void* writer) {
    static auto* const check = librarysOwn<decltype(leitstandCheckAcked)>(LEITSTAND_CHECK_ACKED);
    if (!removals().putsOff(writer)) check(writer);
}

}  // extern "C"

bool mendsTheLibrary() {
    const auto calls = [](const char* name, auto* function) {
        return dlsym(RTLD_NEXT, name) != nullptr &&
               dlsym(RTLD_DEFAULT, name) == reinterpret_cast<void*>(function);
    };
    return calls(LEITSTAND_ENCODE, &leitstandEncode) &&
           calls(LEITSTAND_REMOVE_READER, &leitstandRemoveReader) &&
           calls(LEITSTAND_CHECK_ACKED, &leitstandCheckAcked);
}

}  // namespace leitstand::detail
