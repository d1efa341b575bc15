#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace leitstand::detail {

/// A writer's lock on a mission's folder, held while this object exists (flock: released when the process
/// ends).
class FolderLock {
public:
    /// Locks @p folder. Error when another writer has locked it.
    [[nodiscard]] static Result<FolderLock> take(const std::filesystem::path& folder);
    /// Whether a writer has locked @p folder now.
    [[nodiscard]] static bool isTaken(const std::filesystem::path& folder);
    FolderLock(FolderLock&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}
    FolderLock& operator=(FolderLock&&) = delete;
    ~FolderLock();

private:
    explicit FolderLock(int descriptor) : m_descriptor(descriptor) {}
    int m_descriptor = -1;
};

/// Flushes the entries of @p folder to the disk.
void syncFolder(const std::filesystem::path& folder);

/// A file of a bag and its number: 2 of "mission_2.db3".
struct NumberedFile {
    std::filesystem::path path;
    std::optional<unsigned long> number;
};

/// Returns the files in @p folder that end in @p ending, by number; databases, unless it is another one.
/// Files without a number come last, by name.
[[nodiscard]] Result<std::vector<NumberedFile>> databaseFiles(const std::filesystem::path& folder,
                                                              std::string_view ending = ".db3");

}  // namespace leitstand::detail
