#include "core/io/bag/salvage/overlay_vfs.h"

#include <atomic>
#include <map>
#include <new>

#include <fmt/format.h>
#include <sqlite3.h>

#include "core/io/bag/salvage/overlay_file.h"

namespace leitstand::detail {

struct OverlayVfs::Impl {
    std::string name;
    sqlite3_vfs vfs{};
    sqlite3_vfs* base = nullptr;                                // the system's own
    std::map<std::string, std::shared_ptr<OverlayFile>> files;  // also removed ones, and those only in memory

    /// Returns the file at @p path in its present state.
    std::shared_ptr<OverlayFile> file(const char* path) {
        auto& file = files[path];
        if (!file) file = std::make_shared<OverlayFile>(path);
        return file;
    }
};

namespace {

/// The file object that SQLite allocates.
struct OpenFile {
    sqlite3_file base;  // first: SQLite knows only this
    std::shared_ptr<OverlayFile> content;
};

OverlayFile& contentOf(sqlite3_file* file) {
    return *reinterpret_cast<OpenFile*>(file)->content;
}

OverlayVfs::Impl& implOf(sqlite3_vfs* vfs) {
    return *static_cast<OverlayVfs::Impl*>(vfs->pAppData);
}

int closeFile(sqlite3_file* file) {
    std::destroy_at(&reinterpret_cast<OpenFile*>(file)->content);
    return SQLITE_OK;
}

int readFile(sqlite3_file* file, void* into, int size, sqlite3_int64 offset) {
    const OverlayFile& content = contentOf(file);
    const auto length = static_cast<std::size_t>(size);
    if (!content.read(offset, {static_cast<std::byte*>(into), length})) return SQLITE_IOERR_READ;
    return offset + size <= content.size() ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
}

int writeFile(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 offset) {
    contentOf(file).write(offset, {static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)});
    return SQLITE_OK;
}

int truncateFile(sqlite3_file* file, sqlite3_int64 size) {
    contentOf(file).resize(size);
    return SQLITE_OK;
}

int fileSize(sqlite3_file* file, sqlite3_int64* size) {
    *size = contentOf(file).size();
    return SQLITE_OK;
}

int notLocked(sqlite3_file*, int* reserved) {
    *reserved = 0;
    return SQLITE_OK;
}

// Version 1: no shared memory, so the index of a write-ahead log stays in our memory.
constexpr sqlite3_io_methods Methods = {
    .iVersion = 1,
    .xClose = closeFile,
    .xRead = readFile,
    .xWrite = writeFile,
    .xTruncate = truncateFile,
    .xSync = [](sqlite3_file*, int) { return SQLITE_OK; },
    .xFileSize = fileSize,
    .xLock = [](sqlite3_file*, int) { return SQLITE_OK; },
    .xUnlock = [](sqlite3_file*, int) { return SQLITE_OK; },
    .xCheckReservedLock = notLocked,
    .xFileControl = [](sqlite3_file*, int, void*) { return SQLITE_NOTFOUND; },
    .xSectorSize = [](sqlite3_file*) { return 4'096; },
    .xDeviceCharacteristics = [](sqlite3_file*) { return 0; },
    .xShmMap = nullptr,
    .xShmLock = nullptr,
    .xShmBarrier = nullptr,
    .xShmUnmap = nullptr,
    .xFetch = nullptr,
    .xUnfetch = nullptr,
};

int openFile(sqlite3_vfs* vfs, const char* path, sqlite3_file* file, int flags, int* outFlags) {
    auto* opened = reinterpret_cast<OpenFile*>(file);
    opened->base.pMethods = nullptr;  // until it is open
    // A file without a name is a temporary one.
    auto content = path != nullptr ? implOf(vfs).file(path) : std::make_shared<OverlayFile>();
    if (!content->exists() && (flags & SQLITE_OPEN_CREATE) == 0) return SQLITE_CANTOPEN;
    content->create();
    new (&opened->content) std::shared_ptr<OverlayFile>(std::move(content));
    opened->base.pMethods = &Methods;
    if (outFlags != nullptr) *outFlags = flags;
    return SQLITE_OK;
}

int deleteFile(sqlite3_vfs* vfs, const char* path, int) {
    const auto file = implOf(vfs).file(path);
    if (!file->exists()) return SQLITE_IOERR_DELETE_NOENT;
    file->remove();
    return SQLITE_OK;
}

int accessFile(sqlite3_vfs* vfs, const char* path, int, int* yes) {
    const auto file = implOf(vfs).file(path);
    *yes = file->exists() && file->size() > 0;  // as SQLite's own VFS for SQLITE_ACCESS_EXISTS
    return SQLITE_OK;
}

int fullPath(sqlite3_vfs* vfs, const char* path, int size, char* out) {
    sqlite3_vfs* base = implOf(vfs).base;
    return base->xFullPathname(base, path, size, out);
}

int randomness(sqlite3_vfs* vfs, int size, char* out) {
    sqlite3_vfs* base = implOf(vfs).base;
    return base->xRandomness(base, size, out);
}

int sleepFor(sqlite3_vfs* vfs, int microseconds) {
    sqlite3_vfs* base = implOf(vfs).base;
    return base->xSleep(base, microseconds);
}

int currentTime(sqlite3_vfs* vfs, double* time) {
    sqlite3_vfs* base = implOf(vfs).base;
    return base->xCurrentTime(base, time);
}

std::string nextName() {
    static std::atomic<unsigned> count = 0;
    return fmt::format("leitstand-overlay-{}", ++count);
}

}  // namespace

OverlayVfs::OverlayVfs() : m_impl(std::make_unique<Impl>()) {
    m_impl->name = nextName();
    m_impl->base = sqlite3_vfs_find(nullptr);
    sqlite3_vfs& vfs = m_impl->vfs;
    vfs.iVersion = 1;
    vfs.szOsFile = sizeof(OpenFile);
    vfs.mxPathname = m_impl->base->mxPathname;
    vfs.zName = m_impl->name.c_str();
    vfs.pAppData = m_impl.get();
    vfs.xOpen = openFile;
    vfs.xDelete = deleteFile;
    vfs.xAccess = accessFile;
    vfs.xFullPathname = fullPath;
    vfs.xRandomness = randomness;
    vfs.xSleep = sleepFor;
    vfs.xCurrentTime = currentTime;
    sqlite3_vfs_register(&vfs, /*makeDflt=*/0);
}

OverlayVfs::~OverlayVfs() {
    sqlite3_vfs_unregister(&m_impl->vfs);
}

const std::string& OverlayVfs::name() const {
    return m_impl->name;
}

}  // namespace leitstand::detail
