#include "core/io/bag/writing/session_folder.h"

#include <algorithm>
#include <system_error>

#include <sys/statvfs.h>

#include <fmt/format.h>

#include "core/io/bag/writing/earlier_sessions.h"
#include "core/io/detail/output_file.h"

namespace leitstand::detail {

namespace fs = std::filesystem;

namespace {

fs::path normal(const fs::path& folder) {
    std::error_code ignored;
    fs::path whole = fs::absolute(folder, ignored).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

bool SessionBooks::add(const TopicInfo& topic) {
    const auto id = static_cast<std::int64_t>(ids.size() + 1);
    if (!ids.try_emplace({topic.name, topic.type}, id).second) return false;
    metadata.topics.push_back({topic, 0});
    return true;
}

std::optional<std::int64_t> SessionBooks::topicOfNext(const RawEvent& event) const {
    const auto topic = ids.find({event.topic, event.type});
    const bool fits = topic != ids.end() && event.sequence > lastSequence && event.cdr;
    return fits ? std::optional(topic->second) : std::nullopt;
}

void SessionBooks::count(const RawEvent& event, std::int64_t id) {
    lastSequence = event.sequence;
    ++metadata.topics[static_cast<std::size_t>(id - 1)].messages;
    auto& file = metadata.files.front();
    if (file.messages++ == 0) file.first = file.last = event.received;
    file.first = std::min(file.first, event.received);
    file.last = std::max(file.last, event.received);
}

Result<SessionFolder> SessionFolder::open(const fs::path& given, std::optional<BagStorage> storage) {
    const fs::path path = normal(given);
    std::error_code problem;
    fs::create_directories(path, problem);
    if (problem) return Error{fmt::format("{}: cannot be made: {}", path.string(), problem.message())};
    auto lock = FolderLock::take(path);
    if (!lock) return lock.error();
    auto found = earlierSessions(path, storage);
    if (!found) return found.error();
    EarlierSessions earlier = std::move(found).value();
    SessionFolder folder(path, std::move(lock).value());
    folder.m_file = earlier.nextFile;
    folder.m_storage = earlier.storage;
    folder.m_earlierSequence = earlier.lastSequence;
    folder.m_earlier = std::move(earlier.metadata);
    return folder;
}

SessionBooks SessionFolder::newBooks() const {
    SessionBooks books;
    books.lastSequence = m_earlierSequence;
    books.metadata.storage = nameOf(m_storage);
    books.metadata.files = {{m_file.filename().string(), {}, {}, 0}};
    return books;
}

std::uint64_t SessionFolder::freeBytes() const {
    struct statvfs disk {};
    if (::statvfs(m_folder.c_str(), &disk) != 0) return 0;
    return static_cast<std::uint64_t>(disk.f_bavail) * disk.f_frsize;
}

void SessionFolder::writeMetadata(const SessionBooks& books) const {
    BagMetadata whole = m_earlier;
    whole.storage = nameOf(m_storage);
    whole.files.insert(whole.files.end(), books.metadata.files.begin(), books.metadata.files.end());
    for (const auto& topic : books.metadata.topics) {
        const auto same = std::find_if(whole.topics.begin(), whole.topics.end(), [&](const auto& other) {
            return other.info.name == topic.info.name && other.info.type == topic.info.type;
        });
        if (same == whole.topics.end()) {
            whole.topics.push_back(topic);
        } else {
            same->messages += topic.messages;
        }
    }
    whole.custom[std::string(CountedKey)] = std::to_string(books.lastSequence);
    (void)writeWhole(m_folder / "metadata.yaml", yamlOf(whole, /*bare=*/false));
}

void SessionFolder::sync() const {
    syncFolder(m_folder.parent_path());
    syncFolder(m_folder);
}

StoreProblem SessionFolder::refusal(const RawEvent& event, std::size_t index,
                                    const SessionBooks& books) const {
    return {StoreProblem::Kind::Refused,
            fmt::format("{}: event {} of {}: expected a known topic, bytes and a sequence above {}",
                        m_file.string(), event.sequence, event.topic, books.lastSequence),
            index};
}

}  // namespace leitstand::detail
