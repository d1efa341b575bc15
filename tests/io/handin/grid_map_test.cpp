#include "core/io/handin/grid_map.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using State = OccupancyGrid::State;
using testing::HasSubstr;

class GridMap : public testing::Test {
protected:
    /// The error of reading the map with these files.
    [[nodiscard]] std::string errorOf(const std::string& yaml, const std::string& image) const {
        writeText(m_folder / "map.yaml", yaml);
        writeText(m_folder / "map.pgm", image);
        const auto read = readGridMap(m_folder / "map.yaml");
        return read ? "no error" : read.error().text;
    }
    [[nodiscard]] OccupancyGrid read(const std::string& yaml, const std::string& image) const {
        writeText(m_folder / "map.yaml", yaml);
        writeText(m_folder / "map.pgm", image);
        auto read = readGridMap(m_folder / "map.yaml");
        EXPECT_TRUE(read) << read.error().text;
        return read ? std::move(read).value() : OccupancyGrid();
    }
    const TemporaryFolder m_folder;
    const std::string m_yaml = "image: map.pgm\nresolution: 0.1\norigin: [-2, 3.5, 0.0]\n";
    const std::string m_image = std::string("P5\n3 2\n255\n") + '\x00' + "\xFE\xCD" + "\xCD\xFE" + '\x00';
};

TEST_F(GridMap, ComesBackAsItWasWritten) {
    OccupancyGrid grid;
    grid.cell = 0.05;
    grid.origin = {-1.35, 12.05};
    grid.columns = 4;
    grid.rows = 3;
    grid.cells.resize(12);
    grid.cells[0].state = grid.cells[5].state = State::Occupied;
    grid.cells[3].state = grid.cells[11].state = State::Free;
    ASSERT_TRUE(writeGridMap(m_folder / "way.pgm", grid));
    const auto read = readGridMap(m_folder / "way.yaml");
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_EQ(read->columns, 4);
    EXPECT_EQ(read->rows, 3);
    EXPECT_DOUBLE_EQ(read->cell, 0.05);
    EXPECT_LT((read->origin - grid.origin).norm(), 1e-9);
    for (std::size_t i = 0; i < grid.cells.size(); ++i)
        EXPECT_EQ(read->cells[i].state, grid.cells[i].state) << i;
}

TEST_F(GridMap, ThePicturesFirstRowIsTheOneWithTheLargestY) {
    const OccupancyGrid grid = read(m_yaml, m_image);
    EXPECT_EQ(grid.at(-1.95, 3.65).state, State::Occupied);
    EXPECT_EQ(grid.at(-1.85, 3.65).state, State::Free);
    EXPECT_EQ(grid.at(-1.75, 3.55).state, State::Occupied);
    EXPECT_EQ(grid.at(-1.95, 3.55).state, State::Unexplored);
}

TEST_F(GridMap, ModesAndNegationAreThoseOfMapServer) {
    const auto first = [&](const std::string& more, char pixel) {
        return read(m_yaml + more, std::string("P5 1 1 255\n") + pixel).cells.at(0).state;
    };
    EXPECT_EQ(first("negate: 1\n", '\xFF'), State::Occupied);
    EXPECT_EQ(first("negate: 1\n", '\x00'), State::Free);
    EXPECT_EQ(first("mode: raw\n", '\x64'), State::Occupied);
    EXPECT_EQ(first("mode: raw\n", '\x00'), State::Free);
    EXPECT_EQ(first("mode: raw\n", '\xFF'), State::Unexplored);
    EXPECT_EQ(first("mode: scale\n", '\x80'), State::Unexplored);
    EXPECT_EQ(first("occupied_thresh: 0.4\n", '\x80'), State::Occupied);
}

TEST_F(GridMap, CommentsInThePicturesHeadAreSkipped) {
    EXPECT_EQ(read(m_yaml, "P5\n# CREATOR: map_saver 0.050 m/pix\n1 1\n255\n\xFE").cells.at(0).state,
              State::Free);
}

TEST_F(GridMap, ErrorsNameTheFileThePlaceAndWhatWasExpected) {
    EXPECT_THAT(errorOf("image: map.pgm\norigin: [0, 0, 0]\n", m_image),
                HasSubstr("map.yaml:1: resolution: expected"));
    EXPECT_THAT(errorOf(m_yaml + "mode: colours\n", m_image), HasSubstr("expected trinary, scale or raw"));
    EXPECT_THAT(errorOf("image: map.pgm\nresolution: .nan\norigin: [0, 0, 0]\n", m_image),
                HasSubstr("resolution"));
    EXPECT_THAT(errorOf("image: map.pgm\nresolution: 0.1\norigin: [0, 0, 0.3]\n", m_image),
                HasSubstr("expected a map that is not turned"));
    EXPECT_THAT(errorOf("image: none.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n", m_image),
                HasSubstr("none.pgm"));
    EXPECT_THAT(errorOf(m_yaml, "P2\n1 1\n255\n0\n"), HasSubstr("map.pgm: expected a binary PGM"));
    EXPECT_THAT(errorOf(m_yaml, ""), HasSubstr("map.pgm: expected a binary PGM"));
    EXPECT_THAT(errorOf(m_yaml, "P5\n-3 2\n255\n"), HasSubstr("expected a binary PGM"));
    EXPECT_THAT(errorOf(m_yaml, "P5\n99999 99999\n255\n"), HasSubstr("expected at most"));
    EXPECT_THAT(errorOf(m_yaml, m_image.substr(0, m_image.size() - 1)),
                HasSubstr("expected 6 bytes of pixels, found 5"));
    EXPECT_THAT(errorOf(std::string(300'000, '#'), m_image), HasSubstr("expected at most"));
    EXPECT_FALSE(readGridMap(m_folder / "absent.yaml"));
}

}  // namespace
}  // namespace leitstand::test
