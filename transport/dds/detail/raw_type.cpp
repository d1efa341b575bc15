#include "transport/dds/detail/raw_type.h"

#include <cstring>

#include "transport/cdr/encapsulation.h"

namespace leitstand::detail {
namespace rtps = eprosima::fastrtps::rtps;

RawType::RawType(const std::string& ddsName) {
    setName(ddsName.c_str());
    m_typeSize = 256;  // where payloads begin to grow from, no limit
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);
    auto_fill_type_information(false);
}

bool RawType::serialize(void* sample, rtps::SerializedPayload_t* payload) {
    const auto& bytes = *static_cast<RawSample*>(sample)->cdr;
    if (bytes.size() < EncapsulationSize || bytes.size() > payload->max_size) return false;
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<uint32_t>(bytes.size());
    payload->encapsulation = std::to_integer<uint16_t>(bytes[1] & std::byte{1}) != 0 ? CDR_LE : CDR_BE;
    return true;
}

bool RawType::deserialize(rtps::SerializedPayload_t* payload, void* sample) {
    const auto* begin = reinterpret_cast<const std::byte*>(payload->data);
    static_cast<RawSample*>(sample)->cdr =
        std::make_shared<const std::vector<std::byte>>(begin, begin + payload->length);
    return true;
}

std::function<uint32_t()> RawType::getSerializedSizeProvider(void* sample) {
    const auto size = static_cast<uint32_t>(static_cast<RawSample*>(sample)->cdr->size());
    return [size] { return size; };
}

void* RawType::createData() {
    return new RawSample;
}

void RawType::deleteData(void* sample) {
    delete static_cast<RawSample*>(sample);
}

bool RawType::getKey(void*, rtps::InstanceHandle_t*, bool) {
    return false;
}

}  // namespace leitstand::detail
