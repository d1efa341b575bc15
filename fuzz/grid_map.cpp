#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/io/handin/grid_map.h"
#include "fuzz/input_file.h"

/// Maps of map_server: the YAML file up to the first 0, then the picture, which it may name "p.pgm".
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const auto* const end = std::find(data, data + size, std::uint8_t{0});
    const fuzz::InputFile yaml(data, static_cast<std::size_t>(end - data));
    const std::filesystem::path image = yaml.path().parent_path() / "p.pgm";
    const auto left = std::max<std::ptrdiff_t>(0, data + size - end - 1);
    std::ofstream(image, std::ios::binary)
        .write(reinterpret_cast<const char*>(end) + (left > 0 ? 1 : 0), left);
    const auto grid = readGridMap(yaml.path());
    fuzz::require(grid.ok() || !grid.error().text.empty(), "an error that tells something");
    if (!grid.ok()) return 0;
    fuzz::require(
        grid->cells.size() == static_cast<std::size_t>(grid->columns) * static_cast<std::size_t>(grid->rows),
        "a cell of each pixel");
    fuzz::require(grid->cell > 0.0 && grid->origin.allFinite(), "a frame");
    return 0;
}
