#pragma once

#include <filesystem>
#include <vector>

namespace leitstand::detail {

/// Cleans up after an unfinished task that makes files and folders step by step. Unless done() is called, the
/// destructor removes those that did not exist before, so that a full disk is left as it was found.
class Unfinished {
public:
    /// Watches @p folder and the folders above it; none of them need exist yet.
    explicit Unfinished(const std::filesystem::path& folder);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    /// Announces that @p file is made next, in a folder that may have existed.
    void file(const std::filesystem::path& file);
    /// Keeps everything that was made.
    void done() { m_made.clear(); }

private:
    std::vector<std::filesystem::path> m_made;  // did not exist before
};

}  // namespace leitstand::detail
