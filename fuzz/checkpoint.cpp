#include "core/mission/state/checkpoint/checkpoint.h"
#include "fuzz/input_file.h"

/// The bytes of a checkpoint: what can be read is written the same, and reads the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const auto state = deserialised({reinterpret_cast<const std::byte*>(data), size});
    if (!state) {
        fuzz::require(!state.error().text.empty(), "an error that tells something");
        return 0;
    }
    const auto once = serialised(*state);
    const auto again = deserialised(once);
    fuzz::require(again.ok(), "a state that can be read again");
    fuzz::require(serialised(*again) == once, "the same state again");
    return 0;
}
