#include "core/robot/services/service_description.h"
#include "fuzz/input_file.h"
#include "transport/services/navigation_messages.h"
#include "transport/services/service_messages.h"

/// Requests and answers of services and actions, with and without the header of rmw_cyclonedds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
    for (const ServiceFacts& facts : serviceTable()) {
        static_cast<void>(decodeRequest(facts.kind, bytes));
        const auto answer = decodeAnswer(facts.kind, bytes);
        if (!answer) continue;
        const auto again = decodeAnswer(facts.kind, *encodeAnswer(facts.kind, *answer));
        fuzz::require(again.ok() && again->accepted == answer->accepted, "the same answer again");
    }
    static_cast<void>(decodeGoal(bytes));
    static_cast<void>(decodeCancel(bytes));
    static_cast<void>(decodeAcceptance(bytes));
    static_cast<void>(decodeProgress(bytes));
    if (const auto goals = decodeStatus(bytes)) {
        const auto again = decodeStatus(*encodeStatus(*goals));
        fuzz::require(again.ok() && again->size() == goals->size(), "the same goals again");
    }
    if (const auto split = splitHeader(bytes)) {
        const auto same = splitHeader(*withHeader(split->header, split->body));
        fuzz::require(same && same->header == split->header, "the same header again");
        fuzz::require(*same->body == *split->body, "the same body again");
    }
    return 0;
}
