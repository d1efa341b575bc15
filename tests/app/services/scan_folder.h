#pragma once

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/io/clouds/uos.h"
#include "tests/support/rooms.h"

namespace leitstand::test {

/// Writes a drive of @p count small scans through the furnished default room into @p folder as scan000.3d and
/// so on. The odometry is some centimetres wrong; scan i truly stands at (0.3 i, 0, 0) of the first.
inline void writeDrive(const std::filesystem::path& folder, int count, int rows = 58, int columns = 90) {
    std::filesystem::create_directories(folder);
    for (int i = 0; i < count; ++i) {
        RoomSettings settings;
        settings.sensorInRoom = poseFrom({-1.5 + 0.3 * i, 0, 0.9}, 0, 0, 0);
        settings.rows = rows;
        settings.columns = columns;
        settings.seed = static_cast<unsigned>(i + 1);
        Scan scan = scanRoom(settings).scan;
        scan.sensorInOdom = poseFrom({0.33 * i, 0.02 * i, 0}, 0, 0, degrees(0.5 * i));
        const auto written = writeUosScan(folder / fmt::format("scan{:03}.3d", i), scan);
        ASSERT_TRUE(written.ok()) << written.error().text;
    }
}

}  // namespace leitstand::test
