#include "core/io/clouds/cloud_formats.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/uos.h"
#include "core/io/clouds/xyz.h"
#include "core/io/detail/numbers.h"

namespace leitstand {

namespace fs = std::filesystem;

std::span<const CloudFormat> cloudFormats() {
    static constexpr std::array<CloudFormat, 4> Formats = {
        {{".3d", &readUosScan},  // written only together with its pose (cloud_writer.h)
         {".pcd", &readPcd, [](const fs::path& file, const Scan& cloud) { return writePcd(file, cloud); }},
         {".ply", &readPly, [](const fs::path& file, const Scan& cloud) { return writePly(file, cloud); }},
         {".xyz", &readXyz, &writeXyz}}};
    return Formats;
}

const CloudFormat* cloudFormatOf(const std::filesystem::path& file) {
    const std::string ending = detail::lowerCase(file.extension().string());
    const auto formats = cloudFormats();
    const auto found = std::find_if(formats.begin(), formats.end(),
                                    [&](const CloudFormat& one) { return one.ending == ending; });
    return found != formats.end() ? &*found : nullptr;
}

std::string listOf(CloudEndings which, std::string_view between, std::string_view last) {
    std::vector<std::string_view> endings;
    for (const CloudFormat& format : cloudFormats()) {
        if (which == CloudEndings::All || format.write != nullptr) endings.push_back(format.ending);
    }
    std::string list;
    for (std::size_t i = 0; i < endings.size(); ++i) {
        if (i > 0) list += i + 1 < endings.size() ? between : last;
        list += endings[i];
    }
    return list;
}

}  // namespace leitstand
