#include "widgets/map_view/scene/points/scan_points.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

constexpr double MinRange = 0.4, MaxRange = 15.0;

/// Points of two walls in upright rows, one wall after the other, as a key scan of the live map has them.
Scan keyScan(std::size_t count) {
    constexpr std::size_t Row = 50;
    Scan scan;
    for (std::size_t i = 0; i < count; ++i) {
        const float along = -4.0F + 8.0F * static_cast<float>(i) / static_cast<float>(count);
        const float up = -0.5F + 2.0F * static_cast<float>(i % Row) / static_cast<float>(Row);
        scan.points.emplace_back(along, i < count / 2 ? 2.0F : -2.0F, up);
        scan.labels.push_back(i % 5 == 0 ? Label::Ceiling : Label::Wall);
    }
    return scan;
}

TEST(ScanPoints, AKeyScanIsDrawnFromItsOwnMemory) {
    const auto scan = std::make_shared<const Scan>(keyScan(10'000));
    const ScanPoints points = drawablePoints(scan, MinRange, MaxRange);
    EXPECT_EQ(points.points.data(), scan->points.data());
    EXPECT_EQ(points.labels.data(), scan->labels.data());
    // Its order is two bytes each; for picking, the places of whole runs of points are kept.
    EXPECT_LE(points.memory(*scan), 3 * scan->points.size());
    EXPECT_EQ(points.labelCounts[static_cast<std::size_t>(Label::Ceiling)], 2'000U);
}

TEST(ScanPoints, WhatCannotBeDrawnIsLeftOut) {
    Scan scan = keyScan(1'000);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scan.points[3] = {nan, nan, nan};
    scan.points[10] = {0.1F, 0.0F, 0.0F};
    scan.points[20] = {40.0F, 0.0F, 0.0F};
    const auto shared = std::make_shared<const Scan>(std::move(scan));
    const ScanPoints points = drawablePoints(shared, MinRange, MaxRange);
    ASSERT_EQ(points.points.size(), 997U);
    ASSERT_EQ(points.labels.size(), 997U);
    EXPECT_NE(points.owner, shared) << "the scan's memory may go";
    for (const Eigen::Vector3f& point : points.points) {
        EXPECT_TRUE(point.norm() >= 0.4F && point.norm() <= 15.0F) << point.transpose();
    }
}

TEST(ScanPoints, ShadesGoAlongWithTheirPoints) {
    Scan scan = keyScan(1'000);
    scan.points[0] = {40.0F, 0.0F, 0.0F};
    for (std::size_t i = 0; i < scan.points.size(); ++i)
        scan.shades.push_back(static_cast<std::uint8_t>(i % 250));
    const ScanPoints some = drawablePoints(std::make_shared<const Scan>(scan), MinRange, MaxRange);
    ASSERT_TRUE(some.shades);
    ASSERT_EQ(some.shades->size(), 999U);
    EXPECT_EQ(some.shades->front(), 1);
    EXPECT_EQ(some.shadeOfSample(0), (*some.shades)[(*some.order)[0]]);
    scan.points[0] = {2.0F, 0.0F, 0.0F};
    const auto whole = std::make_shared<const Scan>(scan);
    EXPECT_EQ(drawablePoints(whole, MinRange, MaxRange).shades->data(), whole->shades.data());
    Scan measured = keyScan(1'000);
    measured.intensities.assign(1'000, 255.0F);
    const ScanPoints made = drawablePoints(std::make_shared<const Scan>(measured), MinRange, MaxRange);
    ASSERT_TRUE(made.shades);
    EXPECT_EQ(made.shades->front(), 128);
    EXPECT_FALSE(drawablePoints(std::make_shared<const Scan>(keyScan(10)), MinRange, MaxRange).shades);
}

TEST(ScanPoints, AScanWithoutLabelsIsDrawnUnlabelled) {
    Scan scan = keyScan(100);
    scan.labels.clear();
    const ScanPoints points = drawablePoints(std::make_shared<const Scan>(scan), MinRange, MaxRange);
    ASSERT_EQ(points.labels.size(), 100U);
    EXPECT_EQ(points.labelCounts[static_cast<std::size_t>(Label::Unlabelled)], 100U);
}

TEST(ScanPoints, TheOrderHasEveryPointOnceAndItsBeginningIsAFairSample) {
    const auto scan = std::make_shared<const Scan>(keyScan(10'000));
    const ScanPoints points = drawablePoints(scan, MinRange, MaxRange);
    std::vector<std::size_t> sorted;
    for (std::size_t i = 0; i < points.order->size(); ++i) sorted.push_back((*points.order)[i]);
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted.size(), 10'000U);
    for (std::size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], i);
    std::size_t ceiling = 0;
    for (std::size_t i = 0; i < 1'000; ++i) ceiling += points.labelOfSample(i) == Label::Ceiling ? 1 : 0;
    EXPECT_NEAR(static_cast<double>(ceiling), 200.0, 60.0);
    EXPECT_EQ(points.sample(0), scan->points[(*points.order)[0]]);
}

TEST(ScanPoints, OneOfMorePointsThanTwoBytesCountIsOrderedAllTheSame) {
    const std::size_t count = 70'000;
    const ScanPoints points =
        drawablePoints(std::make_shared<const Scan>(keyScan(count)), MinRange, MaxRange);
    ASSERT_EQ(points.order->size(), count);
    EXPECT_TRUE(points.order->narrow().empty());
    std::vector<bool> met(count);
    for (std::size_t i = 0; i < count; ++i) met.at((*points.order)[i]) = true;
    EXPECT_TRUE(std::all_of(met.begin(), met.end(), [](bool one) { return one; }));
}

TEST(ScanPoints, ItsCellsHaveEveryPointOnce) {
    const auto scan = std::make_shared<const Scan>(keyScan(2'000));
    const ScanPoints points = drawablePoints(scan, MinRange, MaxRange);
    std::vector<int> met(points.points.size());
    for (const PointCell& cell : points.cells) {
        for (std::size_t run = cell.first; run < cell.end; ++run) {
            for (std::size_t i = points.runs[run].first; i < points.runs[run].end; ++i) {
                ++met[i];
                EXPECT_LE((points.points[i] - cell.centre).norm(), cell.radius + 1e-4F);
            }
        }
    }
    EXPECT_TRUE(std::all_of(met.begin(), met.end(), [](int count) { return count == 1; }));
}

TEST(ScanPoints, AnEmptyScanHasNone) {
    const ScanPoints points = drawablePoints(std::make_shared<const Scan>(), MinRange, MaxRange);
    EXPECT_TRUE(points.points.empty() && points.order->empty() && points.cells.empty());
}

}  // namespace
}  // namespace leitstand
