#include "transport/dds/detail/raw_type.h"

#include <cstring>

#include "transport/cdr/encapsulation.h"

namespace leitstand::detail {
namespace rtps = fastdds::rtps;

RawType::RawType(const std::string& ddsName) : NamedType(ddsName, 256) {}

bool RawType::toPayload(const void* sample, rtps::SerializedPayload_t& payload) const {
    const auto& bytes = *static_cast<const RawSample*>(sample)->cdr;
    if (bytes.size() < EncapsulationSize || bytes.size() > payload.max_size) return false;
    std::memcpy(payload.data, bytes.data(), bytes.size());
    payload.length = static_cast<uint32_t>(bytes.size());
    payload.encapsulation = std::to_integer<uint16_t>(bytes[1] & std::byte{1}) != 0 ? CDR_LE : CDR_BE;
    return true;
}

bool RawType::fromPayload(const rtps::SerializedPayload_t& payload, void* sample) const {
    const auto* begin = reinterpret_cast<const std::byte*>(payload.data);
    static_cast<RawSample*>(sample)->cdr =
        std::make_shared<const std::vector<std::byte>>(begin, begin + payload.length);
    return true;
}

std::uint32_t RawType::bytesOf(const void* sample) const {
    return static_cast<std::uint32_t>(static_cast<const RawSample*>(sample)->cdr->size());
}

void* RawType::make() const {
    return new RawSample;
}

void RawType::drop(void* sample) const {
    delete static_cast<RawSample*>(sample);
}

}  // namespace leitstand::detail
