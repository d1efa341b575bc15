#include "core/io/bag/writing/earlier_sessions.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/io/bag/detail/mission_folder.h"
#include "core/io/bag/reading/reader_core.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

/// No log loses more messages. A larger gap to metadata.yaml is not believed.
constexpr std::uint64_t MostLost = 100'000'000;

fs::path nextFile(const fs::path& folder, const std::vector<NumberedFile>& earlier, BagStorage storage) {
    unsigned long next = 0;
    for (const auto& file : earlier) next = std::max(next, file.number ? *file.number + 1 : 0);
    return folder / fmt::format("{}_{}{}", folder.filename().string(), next, endingOf(storage));
}

BagMetadata summaryOf(const ReaderCore& reader) {
    BagMetadata summary;
    for (const BagSession& session : reader.sessions()) {
        const std::uint64_t most =
            session.lastSequence == 0 ? 0 : session.lastSequence - session.firstSequence + 1;
        summary.files.push_back(
            {session.file.filename().string(), session.first, session.last, session.messages.value_or(most)});
        // Missing messages stay recorded when the counts are written again.
        if (session.missing > 0) {
            summary.custom[std::string(MissingKey) + session.file.filename().string()] =
                std::to_string(session.missing);
        }
    }
    for (const BagTopic& topic : reader.topics()) {
        summary.topics.push_back({topic.info, topic.messages.value_or(0)});
    }
    return summary;
}

/// Reads metadata.yaml in @p folder; empty when there is none.
std::optional<Result<BagMetadata>> metadataOf(const fs::path& folder) {
    std::ifstream in(folder / "metadata.yaml", std::ios::binary);
    if (!in) return std::nullopt;
    std::stringstream text;
    text << in.rdbuf();
    return parseMetadata(text.str(), "metadata.yaml");
}

/// Returns how the sessions are stored; empty when there are none. A file of the other kind that lies beside
/// them (a copy, say) is none of the mission's, as for readers.
std::optional<BagStorage> storageOf(const std::vector<NumberedFile>& databases,
                                    const std::vector<NumberedFile>& mcaps,
                                    const std::optional<Result<BagMetadata>>& stated) {
    const bool statedMcap = stated && *stated && (*stated)->storage == nameOf(BagStorage::Mcap);
    if (!mcaps.empty() && (databases.empty() || statedMcap)) return BagStorage::Mcap;
    return databases.empty() ? std::nullopt : std::optional(BagStorage::Sqlite);
}

/// Whether @p stated shows that others wrote it. Without any file, unreadable metadata count as theirs too.
bool isOfOthers(const std::optional<Result<BagMetadata>>& stated, bool anyFile) {
    if (!stated) return false;
    return *stated ? !(*stated)->custom.contains(std::string(CountedKey)) : !anyFile;
}

/// Returns the last sequence that was given out: @p found, or a later one in @p stated. The later one may be
/// in a log that is gone, and is not given out again.
std::uint64_t lastGiven(std::uint64_t found, const std::optional<Result<BagMetadata>>& stated) {
    if (!stated || !*stated) return found;
    const auto counted = (*stated)->custom.find(std::string(CountedKey));
    if (counted == (*stated)->custom.end()) return found;
    const std::uint64_t sequence = numberIn(counted->second).value_or(0);
    return sequence > found && sequence - found < MostLost ? sequence : found;
}

bool anyDamaged(const ReaderCore& reader) {
    return std::any_of(reader.sessions().begin(), reader.sessions().end(),
                       [](const BagSession& session) { return session.damaged; });
}

}  // namespace

Result<EarlierSessions> earlierSessions(const fs::path& folder, std::optional<BagStorage> storage) {
    const auto databases = databaseFiles(folder, endingOf(BagStorage::Sqlite));
    const auto mcaps = databaseFiles(folder, endingOf(BagStorage::Mcap));
    if (!databases) return databases.error();
    if (!mcaps) return mcaps.error();
    const auto stated = metadataOf(folder);
    const auto found = storageOf(*databases, *mcaps, stated);
    EarlierSessions earlier;
    earlier.storage = storage.value_or(found.value_or(BagStorage::Sqlite));
    if (found && *found != earlier.storage)
        return Error{fmt::format(
            "{}: expected a mission in files {}, found files {}: all sessions of a mission are stored alike",
            folder.string(), endingOf(earlier.storage), endingOf(*found))};
    const auto& files = earlier.storage == BagStorage::Mcap ? mcaps : databases;
    earlier.nextFile = nextFile(folder, *files, earlier.storage);
    std::optional<ReaderCore> reader;
    if (!files->empty()) {
        if (auto opened = openBag(folder, Writer::Nobody)) reader.emplace(std::move(opened).value());
    }
    const bool ours = reader && reader->ours();
    const bool whole = reader && !anyDamaged(*reader);
    if (!ours && (whole || isOfOthers(stated, !files->empty()))) {
        return Error{folder.string() +
                     ": expected a mission or an empty folder, found a bag of others; it is left as it is"};
    }
    if (reader) {
        earlier.metadata = summaryOf(*reader);
        earlier.lastSequence = reader->lastSequence();
        if (ours) earlier.lastSequence = lastGiven(earlier.lastSequence, stated);
    }
    return earlier;
}

}  // namespace leitstand::detail
