#pragma once

#include <filesystem>

struct sqlite3;

namespace leitstand::fuzz {

/// A bag of ours with pages of 512 bytes and one topic, at @p file, open in the mode of the write-ahead log
/// with nothing in it yet; null: it could not be made.
[[nodiscard]] sqlite3* openSmallBag(const std::filesystem::path& file);
/// Writes @p transactions of three messages each, which its log keeps.
[[nodiscard]] bool addMessages(sqlite3* bag, int transactions);

}  // namespace leitstand::fuzz
