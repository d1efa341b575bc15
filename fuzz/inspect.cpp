#include <string_view>

#include "app/services/topics/message_inspector.h"
#include "fuzz/input_file.h"

/// The text of a message type, a byte of zero, and a message of it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    const auto end = all.find('\0');
    const auto text = MessageText::parse("p/msg/A", all.substr(0, end));
    if (!text || end == std::string_view::npos) return 0;
    const std::span bytes(reinterpret_cast<const std::byte*>(data) + end + 1, size - end - 1);
    const auto read = inspect(*text, bytes);
    if (!read) return 0;
    fuzz::require(read->fields.size() <= InspectedMessage::MostFields, "no more rows than are shown");
    return 0;
}
