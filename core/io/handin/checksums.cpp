#include "core/io/handin/checksums.h"

#include <array>
#include <fstream>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "core/base/words.h"
#include "core/io/detail/line_reader.h"
#include "core/io/detail/output_file.h"

namespace leitstand {
namespace {

constexpr const char* Name = "SHA256SUMS";

}  // namespace

Result<std::string> sha256Of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened"), file.string())};
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
    bool ok = context != nullptr && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    std::array<char, 1 << 16> chunk{};
    while (ok && in) {
        in.read(chunk.data(), chunk.size());
        ok = EVP_DigestUpdate(context.get(), chunk.data(), static_cast<std::size_t>(in.gcount())) == 1;
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    ok = ok && in.eof() && EVP_DigestFinal_ex(context.get(), digest.data(), &size) == 1;
    if (!ok)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be read"), file.string())};
    std::string text;
    for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
}

Result<void> writeChecksums(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        const auto sum = sha256Of(folder / name);
        if (!sum) return sum.error();
        text += fmt::format("{}  {}\n", *sum, name);
    }
    return detail::writeWhole(folder / Name, text);
}

Result<std::vector<Checksum>> readChecksums(const std::filesystem::path& folder) {
    auto opened = detail::LineReader::open(folder / Name);
    if (!opened) return opened.error();
    detail::LineReader lines = std::move(opened).value();
    std::vector<Checksum> listed;
    std::string_view line;
    while (lines.next(line)) {
        if (line.empty()) continue;
        if (line.size() < 67 || line.substr(64, 2) != "  " || line.find('/') != std::string_view::npos)
            return lines.mismatch("a sum of 64 digits, two blanks and a file's name", line);
        listed.push_back({std::string(line.substr(0, 64)), std::string(line.substr(66))});
    }
    if (lines.failure()) return *lines.failure();
    return listed;
}

Result<std::vector<std::string>> checkChecksums(const std::filesystem::path& folder) {
    const auto listed = readChecksums(folder);
    if (!listed) return listed.error();
    std::vector<std::string> names;
    for (const Checksum& one : *listed) {
        const auto sum = sha256Of(folder / one.name);
        if (!sum) return sum.error();
        if (*sum != one.sum)
            return Error{leitstand::fill(translate("leitstand::Error", "{}: its SHA-256 is not as {} says"),
                                         (folder / one.name).string(), Name)};
        names.push_back(one.name);
    }
    return names;
}

}  // namespace leitstand
