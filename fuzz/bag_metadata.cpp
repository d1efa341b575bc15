#include <string>

#include "core/io/bag/detail/bag_metadata.h"
#include "fuzz/input_file.h"

/// The metadata.yaml of a bag, or its copy in the table metadata. What was read can be written and read
/// again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto metadata = detail::parseMetadata(text, "metadata.yaml");
    if (!metadata) {
        fuzz::require(metadata.error().text.starts_with("metadata.yaml"), "an error that names its file");
        return 0;
    }
    for (const bool bare : {false, true}) {
        const auto again = detail::parseMetadata(detail::yamlOf(*metadata, bare), "again");
        fuzz::require(again.ok(), "metadata that can be read again");
        fuzz::require(again->messages() == metadata->messages(), "the same counts");
        fuzz::require(again->topics.size() == metadata->topics.size(), "the same topics");
    }
    return 0;
}
