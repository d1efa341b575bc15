#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace leitstand::test {

/// Makes an SQLite file as @p sql tells.
void makeDatabase(const std::filesystem::path& file, const std::string& sql);

/// The same with a write-ahead log, in which all of it still stands while @p meanwhile runs.
void makeUnfinishedDatabase(const std::filesystem::path& file, const std::string& sql,
                            const std::function<void()>& meanwhile);

/// What rosbag2 wrote at @p version of its schema: "/talk", and three messages whose times do not rise with
/// their ids.
[[nodiscard]] std::string foreignSchema(int version);

}  // namespace leitstand::test
