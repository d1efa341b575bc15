#pragma once

#include <filesystem>
#include <string>

namespace leitstand::test {

/// A new empty folder that goes, with all in it, at the end of the test. Where the environment has
/// LEITSTAND_KEEP it stays, and is told: to look into what a test that fails now and then made.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return m_path / name; }

private:
    std::filesystem::path m_path;
};

/// Writes @p text to @p file as it is.
void writeText(const std::filesystem::path& file, const std::string& text);
/// The whole content of @p file.
[[nodiscard]] std::string readText(const std::filesystem::path& file);

}  // namespace leitstand::test
