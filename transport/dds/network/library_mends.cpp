#include "transport/dds/network/library_mends.h"

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

/// The writer that this thread takes a reader from, and whether its check has to follow.
struct Removal {
    void* writer = nullptr;
    bool checks = false;
};
thread_local Removal t_removal;

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
    const Removal outer = t_removal;
    t_removal = {writer, false};
    const bool removed = remove(writer, reader);
    const bool checks = t_removal.checks;
    t_removal = outer;
    if (checks) check(writer);
    return removed;
}

void leitstandCheckAcked(void* writer) {
    static auto* const check = librarysOwn<decltype(leitstandCheckAcked)>(LEITSTAND_CHECK_ACKED);
    if (t_removal.writer == writer) {
        t_removal.checks = true;
    } else {
        check(writer);
    }
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
