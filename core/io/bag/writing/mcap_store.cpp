#include "core/io/bag/writing/mcap_store.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "core/io/bag/reading/bag_file.h"

namespace leitstand::detail {

Result<std::unique_ptr<BagStore>> McapStore::create(SessionFolder folder) {
    std::unique_ptr<McapStore> store(new McapStore(std::move(folder)));
    store->m_descriptor = ::open(store->file().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (store->m_descriptor < 0)
        return Error{fmt::format("{}: cannot be made: {}", store->file().string(),
                                 std::generic_category().message(errno))};
    if (const auto failed = store->append(store->m_encoder.take())) return Error{failed->text};
    store->m_folder.writeMetadata(store->m_books);
    store->m_folder.sync();
    return std::unique_ptr<BagStore>(std::move(store));
}

McapStore::~McapStore() {
    if (m_descriptor >= 0) ::close(m_descriptor);
}

StoreProblem McapStore::problem(int number) const {
    const bool noSpace = number == ENOSPC || number == EDQUOT || number == EFBIG;
    return {
        noSpace ? StoreProblem::Kind::DiskFull : StoreProblem::Kind::Failed,
        fmt::format("{}: cannot be written: {}", file().string(), std::generic_category().message(number))};
}

std::optional<StoreProblem> McapStore::append(const std::string& bytes) {
    std::size_t written = 0;
    int failed = 0;
    while (written < bytes.size() && failed == 0) {
        const ssize_t count = ::pwrite(m_descriptor, bytes.data() + written, bytes.size() - written,
                                       static_cast<off_t>(m_length + written));
        if (count > 0) {
            written += static_cast<std::size_t>(count);
        } else if (count == 0) {
            failed = ENOSPC;
        } else if (errno != EINTR) {
            failed = errno;
        }
    }
    if (failed == 0 && ::fdatasync(m_descriptor) != 0) failed = errno;
    if (failed == 0) {
        m_length += bytes.size();
        return std::nullopt;
    }
    // Where this fails too, readers stop at the record that is cut off; the next attempt writes over it.
    (void)!::ftruncate(m_descriptor, static_cast<off_t>(m_length));
    return problem(failed);
}

std::optional<StoreProblem> McapStore::add(const BagBatch& batch, SessionBooks& books) {
    for (const TopicInfo& topic : batch.topics) {
        if (books.ids.size() < McapEncoder::MostTopics && books.add(topic)) m_encoder.add(topic);
    }
    for (std::size_t i = 0; i < batch.events.size(); ++i) {
        const RawEvent& event = batch.events[i];
        const auto topic = books.topicOfNext(event);
        if (!topic || event.cdr->size() > MaxMessageBytes || event.sequence > MaxId)
            return m_folder.refusal(event, i, books);
        m_encoder.add(books.metadata.topics[static_cast<std::size_t>(*topic - 1)].info, event);
        books.count(event, *topic);
    }
    m_encoder.endChunk();
    return std::nullopt;
}

std::optional<StoreProblem> McapStore::commit(const BagBatch& batch) {
    if (batch.empty()) return std::nullopt;
    const McapEncoder::Mark before = m_encoder.mark();
    SessionBooks books = m_books;
    auto failed = add(batch, books);
    if (!failed) failed = append(m_encoder.take());
    if (failed) {
        m_encoder.goBackTo(before);
        return failed;
    }
    m_books = std::move(books);
    if (batch.metadata) m_folder.writeMetadata(m_books);
    return std::nullopt;
}

std::optional<StoreProblem> McapStore::close() {
    if (m_descriptor < 0) return std::nullopt;
    m_encoder.endFile();
    auto failed = append(m_encoder.take());
    ::close(std::exchange(m_descriptor, -1));
    m_folder.writeMetadata(m_books);
    return failed;
}

}  // namespace leitstand::detail
