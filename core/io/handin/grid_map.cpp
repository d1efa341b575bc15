#include "core/io/handin/grid_map.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/words.h"
#include "core/io/detail/input_file.h"
#include "core/io/detail/output_file.h"
#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_fields.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;
using State = OccupancyGrid::State;

constexpr std::size_t MostCells = 100'000'000;
constexpr double Occupied = 0.65, Free = 0.196;  ///< thresholds by which 205 is neither
constexpr auto Keys = std::to_array<std::string_view>(
    {"image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"});
enum class Mode : std::uint8_t { Trinary, Scale, Raw };

std::uint8_t pixelOf(State state) {
    switch (state) {
        case State::Occupied:
            return 0;
        case State::Free:
            return 254;
        case State::Unexplored:
            break;
    }
    return 205;
}

/// What the YAML file says about the picture.
struct GridMapFile {
    std::string image;
    Mode mode = Mode::Trinary;
    double resolution = 0.0;  ///< [m]
    std::vector<double> origin = {0.0, 0.0, 0.0};
    bool negate = false;
    double occupied = Occupied, free = Free;

    [[nodiscard]] State stateOf(std::uint8_t pixel) const {
        if (mode == Mode::Raw)  // percent, 255 unknown
            return pixel > 100                 ? State::Unexplored
                   : pixel >= 100.0 * occupied ? State::Occupied
                   : pixel <= 100.0 * free     ? State::Free
                                               : State::Unexplored;
        const double dark = (negate ? pixel : 255 - pixel) / 255.0;
        if (dark > occupied) return State::Occupied;
        return dark < free ? State::Free : State::Unexplored;
    }
};

Result<GridMapFile> readYaml(const fs::path& yaml) {
    const auto file = detail::InputFile::open(yaml);
    if (!file) return file.error();
    if (file->size() > detail::LargestYaml)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected at most {} bytes, found {}"),
                                     yaml.string(), detail::LargestYaml, file->size())};
    std::ostringstream text;
    text << std::ifstream(yaml, std::ios::binary).rdbuf();
    const auto root = detail::loadYaml(text.str(), yaml.string());
    if (!root) return root.error();
    detail::YamlErrors errors(yaml.string());
    const detail::YamlFields fields({*root, {}, 1}, Keys, errors);
    GridMapFile map;
    for (const char* key : {"image", "resolution", "origin"})
        if (!fields.has(key)) fields.fail(key, translate("leitstand::Error", "expected it, found nothing"));
    fields.text("image", map.image);
    fields.choice<Mode>("mode", map.mode,
                        {{"trinary", Mode::Trinary}, {"scale", Mode::Scale}, {"raw", Mode::Raw}});
    fields.number("resolution", map.resolution, 1e-3, 10.0, " m");
    fields.numbers("origin", map.origin, 3, 1e6, "");
    int negate = 0;
    if (fields.has("negate")) fields.count("negate", negate, 0, 1);
    map.negate = negate == 1;
    fields.number("occupied_thresh", map.occupied, 0.0, 1.0, "");
    fields.number("free_thresh", map.free, 0.0, 1.0, "");
    if (map.origin.size() == 3 && map.origin[2] != 0.0)
        fields.fail("origin",
                    leitstand::fill(translate("leitstand::Error",
                                              "expected a map that is not turned, found a yaw of {:g}"),
                                    map.origin[2]));
    if (!errors.empty()) return errors.error();
    return map;
}

/// Reads a number of a PGM's head, after white space and comments; -1: there is none.
long numberIn(std::istream& in) {
    for (int next = in.peek(); next != EOF; next = in.peek()) {
        if (next == '#') {
            std::string comment;
            std::getline(in, comment);
        } else if (std::isspace(next) != 0) {
            in.get();
        } else {
            break;
        }
    }
    long number = 0;
    int digits = 0;
    for (int next = in.peek(); next >= '0' && next <= '9' && digits < 9; next = in.peek(), ++digits)
        number = 10 * number + (in.get() - '0');
    return digits > 0 ? number : -1;
}

Result<void> readPixels(const fs::path& image, const GridMapFile& map, OccupancyGrid& grid) {
    if (const auto file = detail::InputFile::open(image); !file) return file.error();
    std::ifstream in(image, std::ios::binary);
    std::string kind(2, ' ');
    in.read(kind.data(), 2);
    const long width = numberIn(in), height = numberIn(in), most = numberIn(in);
    const int after = in.get();
    const auto cells =
        static_cast<std::size_t>(std::max(0L, width)) * static_cast<std::size_t>(std::max(0L, height));
    if (kind != "P5" || width <= 0 || height <= 0 || most != 255 || std::isspace(after) == 0)
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a binary PGM (P5) with 8 bits a pixel"),
            image.string())};
    if (cells > MostCells)
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: expected at most {} pixels, found {} x {}"),
                            image.string(), MostCells, width, height)};
    std::vector<char> row(static_cast<std::size_t>(width));
    const auto left = fs::file_size(image) - static_cast<std::uintmax_t>(in.tellg());
    if (left < cells)
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: expected {} bytes of pixels, found {}"),
                            image.string(), cells, left)};
    grid.columns = static_cast<int>(width);
    grid.rows = static_cast<int>(height);
    grid.cells.resize(cells);
    for (int y = grid.rows - 1; y >= 0; --y) {
        if (!in.read(row.data(), width))
            return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be read to its end"),
                                         image.string())};
        for (std::size_t x = 0; x < row.size(); ++x)
            grid.cells[static_cast<std::size_t>(y) * row.size() + x].state =
                map.stateOf(static_cast<std::uint8_t>(row[x]));
    }
    return {};
}

}  // namespace

Result<void> writeGridMap(const fs::path& image, const OccupancyGrid& grid) {
    std::string bytes = fmt::format("P5\n{} {}\n255\n", grid.columns, grid.rows);
    bytes.reserve(bytes.size() + grid.cells.size());
    for (int y = grid.rows - 1; y >= 0; --y) {
        for (int x = 0; x < grid.columns; ++x)
            bytes += static_cast<char>(
                pixelOf(grid.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) +
                                   static_cast<std::size_t>(x)]
                            .state));
    }
    if (const auto written = detail::writeWhole(image, bytes); !written) return written.error();
    YAML::Emitter yaml;
    yaml.SetDoublePrecision(9);
    yaml << YAML::BeginMap;
    yaml << YAML::Key << "image" << YAML::Value << image.filename().string();
    yaml << YAML::Key << "mode" << YAML::Value << "trinary";
    yaml << YAML::Key << "resolution" << YAML::Value << grid.cell;
    yaml << YAML::Key << "origin" << YAML::Value << YAML::Flow << YAML::BeginSeq << grid.origin.x()
         << grid.origin.y() << 0.0 << YAML::EndSeq;
    yaml << YAML::Key << "negate" << YAML::Value << 0;
    yaml << YAML::Key << "occupied_thresh" << YAML::Value << Occupied;
    yaml << YAML::Key << "free_thresh" << YAML::Value << Free << YAML::EndMap;
    return detail::writeWhole(fs::path(image).replace_extension(".yaml"), std::string(yaml.c_str()) + "\n");
}

Result<OccupancyGrid> readGridMap(const fs::path& yaml) {
    const auto map = readYaml(yaml);
    if (!map) return map.error();
    const fs::path image = map->image;
    OccupancyGrid grid;
    grid.cell = map->resolution;
    grid.origin = {map->origin[0], map->origin[1]};
    if (const auto read = readPixels(image.is_absolute() ? image : yaml.parent_path() / image, *map, grid);
        !read)
        return read.error();
    return grid;
}

}  // namespace leitstand
