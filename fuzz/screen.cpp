#include "transport/screen/screen.h"
#include "fuzz/input_file.h"

namespace {

using namespace leitstand;

screen::Place placeOf(unsigned number) {
    screen::Place place;
    place.address[12] = 127;
    place.address[15] = static_cast<std::uint8_t>(number >> 2);
    place.port = static_cast<std::uint16_t>(number & 3);
    return place;
}

/// Numbers of what was taken apart are in their ranges, and nothing points outside of the datagram.
void check(std::span<const std::byte> bytes, const screen::Datagram& datagram) {
    for (const screen::Submessage& one : datagram.submessages) {
        fuzz::require(one.first >= 0 && one.last >= -1 && one.gapped >= 0, "numbers in their ranges");
        const bool inside =
            one.payload.empty() || (one.payload.data() >= bytes.data() &&
                                    one.payload.data() + one.payload.size() <= bytes.data() + bytes.size());
        fuzz::require(inside, "a payload inside of the datagram");
    }
    fuzz::require(datagram.submessages.size() <= bytes.size() / 4, "submessages that were there");
}

}  // namespace

/// Datagrams as they come from the network, several one after the other: the first byte says how the node
/// takes part, then each has a byte for its sender, two for its length and its bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    screen::Screen gate({.encrypted = (data[0] & 1) != 0, .relayed = (data[0] & 2) != 0});
    screen::Moment now{std::chrono::hours(1)};
    std::span rest(data + 1, size - 1);
    while (rest.size() > 3) {
        const std::size_t length = std::min<std::size_t>(rest[1] | rest[2] << 8, rest.size() - 3);
        const auto bytes = std::as_bytes(rest.subspan(3, length));
        // Memory of its own: the sanitizer sees what reads beyond.
        const std::vector<std::byte> own(bytes.begin(), bytes.end());
        screen::Datagram datagram;
        const bool parsed = screen::parse(own, datagram).empty();
        if (parsed) check(own, datagram);
        const bool passes = gate.passes(own, placeOf(rest[0]), now);
        fuzz::require(parsed || !passes, "what is no datagram does not pass");
        now += std::chrono::milliseconds(rest[0]);
        rest = rest.subspan(3 + length);
    }
    return 0;
}
