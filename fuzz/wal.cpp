#include <filesystem>
#include <fstream>
#include <string>

#include <sqlite3.h>
#include <unistd.h>

#include "core/io/bag/bag_reader.h"
#include "fuzz/input_file.h"
#include "fuzz/small_bag.h"

namespace {

namespace fs = std::filesystem;

/// A bag whose log the fuzzer writes.
class Bag {
public:
    Bag() {
        fs::create_directories(m_folder);
        sqlite3* bag = leitstand::fuzz::openSmallBag(file());
        leitstand::fuzz::require(bag != nullptr, "a bag");
        sqlite3_close(bag);
    }
    ~Bag() { fs::remove_all(m_folder); }
    [[nodiscard]] fs::path file() const { return m_folder / "bag_0.db3"; }

private:
    fs::path m_folder = fs::temp_directory_path() / ("leitstand-fuzz-wal-" + std::to_string(getpid()));
};

}  // namespace

/// A write-ahead log that was left behind, torn or made up. What is counted can be read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    static const Bag bag;
    {
        std::ofstream log(bag.file().string() + "-wal", std::ios::binary | std::ios::trunc);
        log.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    }
    const auto reader = BagReader::open(bag.file());
    if (!reader) {
        fuzz::require(!reader.error().text.empty(), "an error that tells something");
        return 0;
    }
    (*reader)->count();
    std::uint64_t counted = 0, read = 0;
    for (const BagSession& session : (*reader)->sessions()) counted += session.messages.value_or(0);
    const bool damaged = (*reader)->sessions().front().damaged;
    BagCursor cursor = (*reader)->read();
    while (cursor.next()) ++read;
    fuzz::require(!damaged || counted == read || !(*reader)->problems().empty(), "counts of what is there");
    return 0;
}
