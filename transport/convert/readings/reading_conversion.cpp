#include "transport/convert/readings/reading_conversion.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/event/status_samples.h"
#include "transport/convert/readings/field_numbers.h"

namespace leitstand::detail {
namespace {

std::vector<std::string> pathsOf(const std::vector<ReadingDescription>& readings) {
    std::vector<std::string> paths;
    paths.reserve(readings.size());
    for (const ReadingDescription& one : readings) paths.push_back(one.field);
    return paths;
}

Error unknownType(std::string_view type) {
    return {fmt::format("the fields of messages of type {} are not known", type)};
}

}  // namespace

Result<Sample> decodeReading(const RawEvent& event, const StreamDescription& stream) {
    const MessageText* const text = knownText(event.type);
    if (text == nullptr) return unknownType(event.type);
    const auto found = numbersAt(*text, pathsOf(stream.readings), *event.cdr);
    if (!found) return found.error();
    ReadingSample sample;
    sample.header = found->header;
    for (std::size_t i = 0; i < stream.readings.size(); ++i) {
        const ReadingDescription& reading = stream.readings[i];
        const double value = reading.scale * found->values[i] + reading.offset;
        sample.values.push_back(value);
    }
    return Sample(std::move(sample));
}

Result<Payload> encodeReading(const ReadingSample& sample, std::string_view type) {
    const MessageText* const text = knownText(type);
    if (text == nullptr) return unknownType(type);
    const std::vector<ReadingDescription> readings = usualReadings(type);
    FieldNumbers numbers{sample.header, sample.values};
    for (std::size_t i = 0; i < std::min(readings.size(), numbers.values.size()); ++i)
        numbers.values[i] = (numbers.values[i] - readings[i].offset) / readings[i].scale;
    return messageWith(*text, pathsOf(readings), numbers);
}

}  // namespace leitstand::detail
