#pragma once

#include <string>

#include "core/event/raw_event.h"
#include "transport/dds/detail/fastdds.h"

namespace leitstand::detail {

/// What Fast DDS exchanges with us: the bytes of one sample.
struct RawSample {
    Payload cdr;
};

/// A type without keys whose samples Fast DDS transports as bytes, encapsulation header included. It
/// announces its name, but not its structure, as ROS 2 nodes do.
class RawType final : public fastdds::NamedType {
public:
    explicit RawType(const std::string& ddsName);

private:
    bool toPayload(const void* sample, fastdds::rtps::SerializedPayload_t& payload) const override;
    bool fromPayload(const fastdds::rtps::SerializedPayload_t& payload, void* sample) const override;
    std::uint32_t bytesOf(const void* sample) const override;
    void* make() const override;
    void drop(void* sample) const override;
};

}  // namespace leitstand::detail
