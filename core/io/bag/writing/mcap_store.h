#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/io/bag/mcap/mcap_encoder.h"
#include "core/io/bag/writing/bag_store.h"
#include "core/io/bag/writing/session_folder.h"

namespace leitstand::detail {

/// One session as a new MCAP file in a mission's folder. Each batch becomes chunks of its own, which are on
/// the disk when commit() returns; only the summary is written at the end, and readers do without it.
class McapStore final : public BagStore {
public:
    [[nodiscard]] static Result<std::unique_ptr<BagStore>> create(SessionFolder folder);
    ~McapStore() override;
    McapStore(const McapStore&) = delete;
    McapStore& operator=(const McapStore&) = delete;

    [[nodiscard]] std::optional<StoreProblem> commit(const BagBatch& batch) override;
    [[nodiscard]] std::uint64_t freeBytes() override { return m_folder.freeBytes(); }
    [[nodiscard]] std::optional<StoreProblem> close() override;
    [[nodiscard]] const std::filesystem::path& file() const override { return m_folder.file(); }
    [[nodiscard]] std::uint64_t earlierSequence() const override { return m_folder.earlierSequence(); }

private:
    explicit McapStore(SessionFolder folder)
        : m_folder(std::move(folder)),
          m_encoder(McapEncoder::Sequences::Kept),
          m_books(m_folder.newBooks()) {}

    [[nodiscard]] std::optional<StoreProblem> add(const BagBatch& batch, SessionBooks& books);
    /// Writes @p bytes behind the others and waits for the disk. On failure, the file is as it was.
    [[nodiscard]] std::optional<StoreProblem> append(const std::string& bytes);
    [[nodiscard]] StoreProblem problem(int number) const;

    SessionFolder m_folder;
    McapEncoder m_encoder;
    SessionBooks m_books;
    int m_descriptor = -1;
    std::uint64_t m_length = 0;  ///< of what is on the disk [B]
};

}  // namespace leitstand::detail
