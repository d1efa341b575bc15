#include "core/io/bag/writing/earlier_sessions.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "core/io/bag/bag_reader.h"
#include "core/io/bag/detail/mission_folder.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

fs::path nextFile(const fs::path& folder, const std::vector<NumberedFile>& earlier) {
    unsigned long next = 0;
    for (const auto& file : earlier) next = std::max(next, file.number ? *file.number + 1 : 0);
    return folder / fmt::format("{}_{}.db3", folder.filename().string(), next);
}

BagMetadata summaryOf(const BagReader& reader) {
    BagMetadata summary;
    for (const BagSession& session : reader.sessions()) {
        const std::uint64_t most =
            session.lastSequence == 0 ? 0 : session.lastSequence - session.firstSequence + 1;
        summary.files.push_back(
            {session.file.filename().string(), session.first, session.last, session.messages.value_or(most)});
    }
    for (const BagTopic& topic : reader.topics()) {
        summary.topics.push_back({topic.info, topic.messages.value_or(0)});
    }
    return summary;
}

/// Whether metadata.yaml in @p folder is there and says that others wrote it; where nothing else is there,
/// also when it cannot be read.
bool metadataOfOthers(const fs::path& folder, bool anyFile) {
    std::ifstream in(folder / "metadata.yaml", std::ios::binary);
    if (!in) return false;
    std::stringstream text;
    text << in.rdbuf();
    const auto metadata = parseMetadata(text.str(), "metadata.yaml");
    return metadata ? !metadata->custom.contains(std::string(CountedKey)) : !anyFile;
}

bool anyDamaged(const BagReader& reader) {
    return std::any_of(reader.sessions().begin(), reader.sessions().end(),
                       [](const BagSession& session) { return session.damaged; });
}

}  // namespace

Result<EarlierSessions> earlierSessions(const fs::path& folder) {
    const auto files = databaseFiles(folder);
    if (!files) return files.error();
    EarlierSessions earlier;
    earlier.nextFile = nextFile(folder, *files);
    const auto reader =
        files->empty() ? Result<std::unique_ptr<BagReader>>(Error{}) : BagReader::open(folder);
    const bool ours = reader && (*reader)->ours();
    const bool whole = reader && !anyDamaged(**reader);
    if (!ours && (whole || metadataOfOthers(folder, !files->empty()))) {
        return Error{folder.string() +
                     ": expected a mission or an empty folder, found a bag of others; it is left as it is"};
    }
    if (reader) {
        earlier.metadata = summaryOf(**reader);
        earlier.lastSequence = (*reader)->lastSequence();
    }
    return earlier;
}

}  // namespace leitstand::detail
