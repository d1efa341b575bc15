#include "core/event/raw_event.h"
#include "core/io/bag/bag_reader.h"
#include "fuzz/input_file.h"

/// A file of a bag; what SQLite cannot read is salvaged page by page.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    constexpr int Most = 1'000;  // events; a page may claim any number
    const fuzz::InputFile input(data, size);
    const auto bag = BagReader::open(input.path());
    if (!bag) {
        fuzz::require(!bag.error().text.empty(), "an error that tells something");
        return 0;
    }
    std::uint64_t before = 0;
    int count = 0;
    for (auto cursor = (*bag)->read(); count < Most; ++count) {
        const auto event = cursor.next();
        if (!event) break;
        fuzz::require(event->cdr != nullptr, "bytes in every event");
        before = event->sequence;
    }
    static_cast<void>((*bag)->event(before));
    static_cast<void>((*bag)->sequenceAt((*bag)->last()));
    return 0;
}
