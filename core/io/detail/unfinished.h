#pragma once

#include <filesystem>
#include <vector>

namespace leitstand::detail {

/// What is made step by step and is of no use before it is done: should that fail, what was not there before
/// is removed again, so that a full disk is left as it was found.
class Unfinished {
public:
    /// @p folder and those above it, which need not be there yet.
    explicit Unfinished(const std::filesystem::path& folder);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    /// @p file is made next, in a folder that may have been there.
    void file(const std::filesystem::path& file);
    /// All is made and stays.
    void done() { m_made.clear(); }

private:
    std::vector<std::filesystem::path> m_made;  // was not there
};

}  // namespace leitstand::detail
