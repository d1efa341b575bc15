#include "core/io/handin/geotiff.h"

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include "core/base/words.h"
#include "core/io/detail/output_file.h"

namespace leitstand {
namespace {

constexpr int MostSide = 60'000;  ///< [px]
constexpr double MostPixels = 200e6;

struct CloseData {
    void operator()(void* data) const { GDALClose(data); }
};
using Data = std::unique_ptr<void, CloseData>;

void prepare() {
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        CPLSetErrorHandler(CPLQuietErrorHandler);  // results report what is wrong
    });
}

std::string lastProblem() {
    const char* text = CPLGetLastErrorMsg();
    return text == nullptr || *text == '\0' ? "unknown reason" : text;
}

/// Returns a local frame in metres, without a place on Earth.
std::string localFrame() {
    const std::unique_ptr<void, void (*)(void*)> frame(OSRNewSpatialReference(nullptr),
                                                       [](void* made) { OSRDestroySpatialReference(made); });
    OSRSetLocalCS(frame.get(), "Map of the mission: north is x, east is -y");
    OSRSetLinearUnits(frame.get(), SRS_UL_METER, 1.0);
    char* text = nullptr;
    OSRExportToWkt(frame.get(), &text);
    std::string words = text == nullptr ? "" : text;
    CPLFree(text);
    return words;
}

/// A file that exists only in memory.
class MemoryFile {
public:
    MemoryFile() {
        static std::atomic<unsigned> count = 0;
        m_name = fmt::format("/vsimem/leitstand-{}.tif", ++count);
    }
    ~MemoryFile() { VSIUnlink(m_name.c_str()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    [[nodiscard]] const char* name() const { return m_name.c_str(); }
    [[nodiscard]] std::string_view bytes() const {
        vsi_l_offset size = 0;
        const auto* first = VSIGetMemFileBuffer(m_name.c_str(), &size, false);
        return {reinterpret_cast<const char*>(first), first == nullptr ? 0 : static_cast<std::size_t>(size)};
    }

private:
    std::string m_name;
};

Result<void> paintInto(const MemoryFile& file, const MapPicture& map) {
    GDALDriverH driver = GDALGetDriverByName("GTiff");
    if (driver == nullptr) return Error{"GDAL has no driver for GeoTIFF"};
    char** options = nullptr;
    for (const char* option : {"PHOTOMETRIC=RGB", "COMPRESS=DEFLATE", "PREDICTOR=2", "INTERLEAVE=PIXEL"}) {
        options = CSLAddString(options, option);
    }
    const int width = map.picture.width, height = map.picture.height;
    const Data data(GDALCreate(driver, file.name(), width, height, 3, GDT_Byte, options));
    CSLDestroy(options);
    if (!data) return Error{lastProblem()};
    std::array<double, 6> place = {-map.topLeft.y(), map.perPixel, 0.0, map.topLeft.x(), 0.0, -map.perPixel};
    bool ok = GDALSetGeoTransform(data.get(), place.data()) == CE_None;
    ok = ok && GDALSetProjection(data.get(), localFrame().c_str()) == CE_None;
    auto* pixels = const_cast<std::byte*>(map.picture.bytes.data());  // only read
    ok = ok && GDALDatasetRasterIO(data.get(), GF_Write, 0, 0, width, height, pixels, width, height, GDT_Byte,
                                   3, nullptr, 3, 3 * width, 1) == CE_None;
    GDALFlushCache(data.get());
    if (!ok || CPLGetLastErrorType() >= CE_Failure) return Error{lastProblem()};
    return {};
}

}  // namespace

Result<void> writeGeoTiff(const std::filesystem::path& file, const MapPicture& map) {
    prepare();
    CPLErrorReset();
    const Picture& picture = map.picture;
    const auto expected = 3U * static_cast<std::size_t>(std::max(picture.width, 0)) *
                          static_cast<std::size_t>(std::max(picture.height, 0));
    if (picture.pixel != Picture::Pixel::Rgb8 || picture.bytes.size() != expected || expected == 0)
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: cannot be written: expected a picture of RGB"),
                            file.string())};
    const MemoryFile memory;
    if (const auto painted = paintInto(memory, map); !painted)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be written: {}"),
                                     file.string(), painted.error().text)};
    return detail::writeWhole(file, memory.bytes());
}

Result<MapPicture> readGeoTiff(const std::filesystem::path& file) {
    prepare();
    CPLErrorReset();
    constexpr std::array<const char*, 2> OnlyTiff = {"GTiff", nullptr};
    const Data data(
        GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, OnlyTiff.data(), nullptr, nullptr));
    const auto problem = [&](std::string_view text) {
        return Error{fmt::format("{}: {}", file.string(), text)};
    };
    if (!data) return problem("is no GeoTIFF: " + lastProblem());
    MapPicture map;
    map.picture.width = GDALGetRasterXSize(data.get());
    map.picture.height = GDALGetRasterYSize(data.get());
    const auto width = static_cast<std::size_t>(map.picture.width),
               height = static_cast<std::size_t>(map.picture.height);
    if (map.picture.width > MostSide || map.picture.height > MostSide ||
        static_cast<double>(width) * static_cast<double>(height) > MostPixels)
        return problem(
            leitstand::fill(translate("leitstand::Error", "expected at most {:.0f} pixels, found {} x {}"),
                            MostPixels, width, height));
    if (GDALGetRasterCount(data.get()) < 3 ||
        GDALGetRasterDataType(GDALGetRasterBand(data.get(), 1)) != GDT_Byte)
        return problem(translate("leitstand::Error", "expected three bands of 8 bits (24-bit RGB)"));
    std::array<double, 6> place{};
    if (GDALGetGeoTransform(data.get(), place.data()) != CE_None)
        return problem(translate("leitstand::Error", "expected a georeference"));
    const bool straight = place[2] == 0.0 && place[4] == 0.0;
    if (!straight || !(place[1] > 0.0) || !(std::abs(place[1] + place[5]) < 1e-9))
        return problem(
            translate("leitstand::Error", "expected square pixels, north up (a negative y pixel size)"));
    map.topLeft = {place[3], -place[0]};
    map.perPixel = place[1];
    map.picture.pixel = Picture::Pixel::Rgb8;
    map.picture.bytes.resize(3 * width * height);
    if (GDALDatasetRasterIO(data.get(), GF_Read, 0, 0, map.picture.width, map.picture.height,
                            map.picture.bytes.data(), map.picture.width, map.picture.height, GDT_Byte, 3,
                            nullptr, 3, static_cast<int>(3 * width), 1) != CE_None)
        return problem("cannot be read: " + lastProblem());
    return map;
}

}  // namespace leitstand
