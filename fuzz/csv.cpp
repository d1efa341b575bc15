#include <string>

#include "core/io/handin/find_lists.h"
#include "core/io/handin/search_list.h"
#include "fuzz/input_file.h"

/// Lists of finds and of what was searched. What was read can be written, and begins no formula then.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const fuzz::InputFile file(data, size);
    const auto finds = readFindList(file.path());
    if (finds) {
        for (const ListedFind& find : finds->finds)
            fuzz::require(find.position.allFinite(), "positions that are numbers");
        const std::string text = textOf(*finds);
        for (const char* begin : {",=", ",@", "\n=", "\n@", "\"=", "\"@"}) {
            // In quotes these may stand behind a quote that is doubled.
            fuzz::require(begin[0] == '"' || text.find(begin) == std::string::npos ||
                              text.find('"') != std::string::npos,
                          "fields that begin no formula");
        }
    } else {
        fuzz::require(!finds.error().text.empty(), "an error that tells something");
    }
    const auto rows = readSearchList(file.path());
    fuzz::require(rows.ok() || !rows.error().text.empty(), "an error that tells something");
    return 0;
}
