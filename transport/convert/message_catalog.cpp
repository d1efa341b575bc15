#include "transport/convert/message_catalog.h"

#include <algorithm>

namespace leitstand {

const MessageType* findMessageType(std::string_view rosOrDdsName) {
    const auto types = messageTypes();
    const auto found = std::find_if(types.begin(), types.end(), [&](const MessageType& type) {
        return type.rosName == rosOrDdsName || type.ddsName == rosOrDdsName;
    });
    return found == types.end() ? nullptr : &*found;
}

}  // namespace leitstand
