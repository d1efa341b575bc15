#pragma once

#include <functional>
#include <string>

#include <fastdds/dds/topic/TopicDataType.hpp>

#include "core/mission/raw_event.h"

namespace leitstand::detail {

/// What Fast DDS hands to and fro for us: the bytes of one sample.
struct RawSample {
    Payload cdr;
};

/// A type without keys whose samples Fast DDS carries as bytes, encapsulation header included. It tells
/// others its name and nothing about its structure, as ROS 2 nodes do.
class RawType final : public eprosima::fastdds::dds::TopicDataType {
public:
    explicit RawType(const std::string& ddsName);

    bool serialize(void* sample, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
    bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* sample) override;
    std::function<uint32_t()> getSerializedSizeProvider(void* sample) override;
    void* createData() override;
    void deleteData(void* sample) override;
    bool getKey(void* sample, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool md5) override;
    bool is_bounded() const override { return false; }
    bool is_plain() const override { return false; }
};

}  // namespace leitstand::detail
