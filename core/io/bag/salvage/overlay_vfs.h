#pragma once

#include <memory>
#include <string>

namespace leitstand::detail {

/// A file system for SQLite in which nothing on the disk ever changes: what SQLite writes (the roll-back of a
/// transaction that a killed program left) stays in memory and is gone with this. It takes no locks, so the
/// files must have no writer. Connections need `PRAGMA locking_mode = EXCLUSIVE` to see a write-ahead log.
class OverlayVfs {
public:
    OverlayVfs();
    ~OverlayVfs();  ///< all connections through it are closed by then
    OverlayVfs(const OverlayVfs&) = delete;
    OverlayVfs& operator=(const OverlayVfs&) = delete;

    /// By which SQLite knows it.
    [[nodiscard]] const std::string& name() const;

    struct Impl;

private:
    std::unique_ptr<Impl> m_impl;
};

}  // namespace leitstand::detail
