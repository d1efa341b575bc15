#pragma once

#include <filesystem>
#include <memory>
#include <utility>

#include "core/base/result.h"

namespace leitstand::detail {

/// A file compressed by zstd, as by rosbag2 in its mode "file", unpacked in a folder for temporary files. The
/// copy is removed together with this.
class UnpackedFile {
public:
    /// Unpacks @p file. Error when it is damaged or cut off, or when there is not enough space; then nothing
    /// stays.
    [[nodiscard]] static Result<UnpackedFile> of(const std::filesystem::path& file);
    /// Returns the copy of @p file that is in use, or makes one with of(): a bag is opened several times in a
    /// row. A file that was written since is unpacked again. Any thread.
    [[nodiscard]] static Result<std::shared_ptr<const UnpackedFile>> shared(
        const std::filesystem::path& file);
    UnpackedFile(UnpackedFile&& other) noexcept
        : m_folder(std::exchange(other.m_folder, {})), m_name(std::move(other.m_name)) {}
    UnpackedFile& operator=(UnpackedFile&&) = delete;
    ~UnpackedFile();

    [[nodiscard]] std::filesystem::path path() const { return m_folder / m_name; }  ///< of the copy

private:
    UnpackedFile(std::filesystem::path folder, std::filesystem::path name)
        : m_folder(std::move(folder)), m_name(std::move(name)) {}
    std::filesystem::path m_folder;  ///< of its own; empty: moved from
    std::filesystem::path m_name;
};

}  // namespace leitstand::detail
