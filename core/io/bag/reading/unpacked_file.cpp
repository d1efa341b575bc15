#include "core/io/bag/reading/unpacked_file.h"

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>
#include <vector>

#include <zstd.h>

#include "core/base/words.h"

namespace leitstand::detail {
namespace {

namespace fs = std::filesystem;

/// Returns the size of @p file when unpacked, as its head says; empty: it says nothing.
std::optional<std::uint64_t> unpackedSize(const fs::path& file) {
    std::vector<char> head(64);  // a frame's head has 18 bytes at most
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    const auto size = ZSTD_getFrameContentSize(head.data(), static_cast<std::size_t>(in.gcount()));
    const bool known = size != ZSTD_CONTENTSIZE_UNKNOWN && size != ZSTD_CONTENTSIZE_ERROR;
    return known ? std::optional<std::uint64_t>(size) : std::nullopt;
}

/// Unpacks @p from into @p to. Returns what went wrong, in words; empty: nothing.
std::string unpack(const fs::path& from, const fs::path& to) {
    const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                            &ZSTD_freeDStream);
    std::ifstream in(from, std::ios::binary);
    std::ofstream out(to, std::ios::binary);
    std::vector<char> packed(ZSTD_DStreamInSize()), plain(ZSTD_DStreamOutSize());
    std::size_t left = 1;  // of a frame, as the library hints
    while (stream && in.read(packed.data(), static_cast<std::streamsize>(packed.size())).gcount() > 0) {
        ZSTD_inBuffer input{packed.data(), static_cast<std::size_t>(in.gcount()), 0};
        bool full = false;  // the output was; there may be more of it
        while (input.pos < input.size || full) {
            ZSTD_outBuffer output{plain.data(), plain.size(), 0};
            left = ZSTD_decompressStream(stream.get(), &output, &input);
            if (ZSTD_isError(left) != 0)
                return translate("leitstand::Error",
                                 "expected a file compressed by zstd, found one that is damaged");
            out.write(plain.data(), static_cast<std::streamsize>(output.pos));
            full = output.pos == output.size && left != 0;
        }
        if (!out) return leitstand::fill(translate("leitstand::Error", "{} cannot be written"), to.string());
    }
    if (left != 0)
        return translate("leitstand::Error", "expected a file compressed by zstd, found one that is cut off");
    out.close();
    return out ? std::string()
               : leitstand::fill(translate("leitstand::Error", "{} cannot be written"), to.string());
}

}  // namespace

Result<UnpackedFile> UnpackedFile::of(const fs::path& file) {
    std::error_code problem;
    const fs::path temporary = fs::temp_directory_path(problem);
    const auto size = unpackedSize(file);
    const auto space = fs::space(temporary, problem);
    if (size && !problem && *size > space.available)
        return Error{leitstand::fill(translate("leitstand::Error",
                                               "{}: expected {} MB of free space in {} to unpack it, found "
                                               "{} MB; TMPDIR names another folder"),
                                     file.string(), (*size >> 20U) + 1, temporary.string(),
                                     space.available >> 20U)};
    std::string folder = (temporary / "leitstand-bag-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be unpacked in {}: {}"),
                                     file.string(), temporary.string(),
                                     std::generic_category().message(errno))};
    UnpackedFile unpacked(folder, file.stem());
    if (const std::string wrong = unpack(file, unpacked.path()); !wrong.empty())
        return Error{file.string() + ": " + wrong};
    return unpacked;
}

Result<std::shared_ptr<const UnpackedFile>> UnpackedFile::shared(const fs::path& file) {
    using Key = std::tuple<fs::path, std::uintmax_t, fs::file_time_type>;
    static std::mutex mutex;
    static std::map<Key, std::weak_ptr<const UnpackedFile>> known;
    std::error_code problem;
    const Key key{fs::weakly_canonical(file, problem), fs::file_size(file, problem),
                  fs::last_write_time(file, problem)};
    const std::lock_guard lock(mutex);  // whoever wants the same file waits for it
    std::erase_if(known, [](const auto& one) { return one.second.expired(); });
    if (const auto found = known.find(key); found != known.end()) {
        if (auto copy = found->second.lock()) return copy;
    }
    auto unpacked = of(file);
    if (!unpacked) return unpacked.error();
    std::shared_ptr<const UnpackedFile> copy = std::make_shared<UnpackedFile>(std::move(unpacked).value());
    if (!problem) known[key] = copy;
    return copy;
}

UnpackedFile::~UnpackedFile() {
    if (m_folder.empty()) return;
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
}

}  // namespace leitstand::detail
