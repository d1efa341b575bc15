#pragma once

#include <filesystem>
#include <vector>

namespace leitstand::detail {

/// Cleans up after a task that makes files and folders step by step and fails. Unless done() was called, the
/// destructor removes all that did not exist before. So a full disk is left as it was.
class Unfinished {
public:
    /// Observes @p folder and the folders above it, which need not exist yet.
    explicit Unfinished(const std::filesystem::path& folder);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    /// Call before making @p file. Its folder may have existed before.
    void file(const std::filesystem::path& file);
    /// Keeps everything that was made.
    void done() { m_made.clear(); }

private:
    std::vector<std::filesystem::path> m_made;  // did not exist before
};

}  // namespace leitstand::detail
