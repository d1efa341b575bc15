#include "core/io/bag/writing/mission_store.h"

#include <utility>

#include "core/io/bag/writing/mcap_store.h"
#include "core/io/bag/writing/session_folder.h"
#include "core/io/bag/writing/sqlite_store.h"

namespace leitstand::detail {

Result<std::unique_ptr<BagStore>> createStore(const std::filesystem::path& folder,
                                              std::optional<BagStorage> storage) {
    auto opened = SessionFolder::open(folder, storage);
    if (!opened) return opened.error();
    return opened->storage() == BagStorage::Mcap ? McapStore::create(std::move(opened).value())
                                                 : SqliteStore::create(std::move(opened).value());
}

}  // namespace leitstand::detail
