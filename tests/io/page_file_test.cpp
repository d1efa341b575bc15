#include "core/io/page_file.h"

#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

std::vector<std::byte> bytesOf(std::size_t count, unsigned first) {
    std::vector<std::byte> bytes(count);
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>(first + 7 * i);
    return bytes;
}

struct Opened {
    TemporaryFolder folder;
    std::shared_ptr<PageFile> file = PageFile::open(folder.path()).value();

    std::uint64_t put(const std::vector<std::byte>& bytes) const {
        const auto page = file->put(bytes);
        EXPECT_TRUE(page);
        return page.value_or(0);
    }
    [[nodiscard]] std::vector<std::byte> read(std::uint64_t page, std::size_t count) const {
        std::vector<std::byte> bytes(count);
        EXPECT_TRUE(file->read(page, bytes));
        return bytes;
    }
};

TEST(PageFile, GivesBackWhatWasPutThere) {
    const Opened opened;
    const auto small = bytesOf(1, 3), large = bytesOf(60'000, 5);
    const std::uint64_t first = opened.put(large), second = opened.put(small), third = opened.put(large);
    EXPECT_EQ(opened.read(second, 1), small);
    EXPECT_EQ(opened.read(first, large.size()), large);
    EXPECT_EQ(opened.read(third, large.size()), large);
    std::vector<std::byte> beyond(60'000);
    EXPECT_FALSE(opened.file->read(10'000, beyond)) << "nothing was put there";
}

TEST(PageFile, StandsInNoFolder) {
    const Opened opened;
    (void)opened.put(bytesOf(10, 1));
    EXPECT_TRUE(std::filesystem::is_empty(opened.folder.path()));
}

TEST(PageFile, UsesAgainWhatIsReleased) {
    const Opened opened;
    const auto bytes = bytesOf(60'000, 1), twice = bytesOf(120'000, 9);
    std::vector<std::uint64_t> pages;
    for (int i = 0; i < 10; ++i) pages.push_back(opened.put(bytes));
    const std::uint64_t size = opened.file->size();
    // Neighbours, in both orders, and one between others.
    for (const std::size_t i : {3U, 2U, 6U, 7U, 9U}) opened.file->release(pages[i], bytes.size());
    const std::uint64_t a = opened.put(twice), b = opened.put(twice), c = opened.put(bytes);
    EXPECT_EQ(opened.file->size(), size);
    EXPECT_EQ(opened.read(a, twice.size()), twice);
    EXPECT_EQ(opened.read(b, twice.size()), twice);
    EXPECT_EQ(opened.read(c, bytes.size()), bytes);
    for (const std::size_t i : {0U, 1U, 4U, 5U, 8U})
        EXPECT_EQ(opened.read(pages[i], bytes.size()), bytes) << i;
}

TEST(PageFile, AFolderThatIsNotThereIsNamed) {
    const auto file = PageFile::open("/nowhere/at/all");
    ASSERT_FALSE(file.ok());
    EXPECT_NE(file.error().text.find("/nowhere/at/all"), std::string::npos);
}

}  // namespace
}  // namespace leitstand::test
