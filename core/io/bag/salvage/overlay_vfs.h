#pragma once

#include <memory>
#include <string>

namespace leitstand::detail {

/// A file system for SQLite that never changes the disk. What SQLite writes (the rollback of a transaction
/// that a killed program left) stays in memory and is lost with this object. It takes no locks, so nobody may
/// be writing to the files. Connections need `PRAGMA locking_mode = EXCLUSIVE` to see a write-ahead log.
class OverlayVfs {
public:
    OverlayVfs();
    ~OverlayVfs();  ///< all connections that use it must be closed
    OverlayVfs(const OverlayVfs&) = delete;
    OverlayVfs& operator=(const OverlayVfs&) = delete;

    /// Its name for SQLite.
    [[nodiscard]] const std::string& name() const;

    struct Impl;

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand::detail
