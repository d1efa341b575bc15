#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include <gtest/gtest.h>

#include "core/mission/coverage/floor_tint.h"
#include "tests/core/mission/coverage/search_scene.h"
#include "widgets/models/coverage/missed_model.h"

namespace leitstand::test {
namespace {

CoverageMapPtr searched() {
    SearchBook book;
    book.add(SearchScene{}.scan());
    EXPECT_TRUE(book.add(viewFrom({-2.0, 0.0, 0.5}, 0.0)));
    return book.coverage(SearchScene::trail());
}

double areaOf(const FloorTint& tint, bool seen) {
    double area = 0.0;
    for (const FloorPatch& patch : tint.patches) {
        if (patch.seen == seen) area += static_cast<double>((patch.high - patch.low).prod());
    }
    return area;
}

TEST(FloorTint, CoversWhatWasSeenAndWhatWasMissedOnce) {
    const auto map = searched();
    const FloorTint tint = floorTintOf(*map, SearchSensor::Camera);
    const double seen = map->seenArea(SearchSensor::Camera), all = map->ground().reachableArea();
    EXPECT_GT(seen, 2.0);
    EXPECT_NEAR(areaOf(tint, true), seen, 0.01);
    EXPECT_NEAR(areaOf(tint, false), all - seen, 0.01);
    EXPECT_LT(static_cast<double>(tint.patches.size()), 0.2 * all * 100.0) << "few patches";
    for (std::size_t i = 0; i < tint.patches.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const FloorPatch &a = tint.patches[i], &b = tint.patches[j];
            const Eigen::Array2f overlap = a.high.cwiseMin(b.high).array() - a.low.cwiseMax(b.low).array();
            ASSERT_LT(overlap.minCoeff(), 0.01F) << i << " lies on " << j;
        }
    }
    EXPECT_TRUE(floorTintOf(CoverageMap(SearchGround{}), SearchSensor::Camera).patches.empty());
}

TEST(MissedModel, ListsTheLargestPieceFirstWithDistanceAndBearing) {
    const auto map = searchedFloorOf({{{}, searched()}});
    const auto nothing = searchedFloorOf({{{}, std::make_shared<const CoverageMap>(SearchGround{})}});
    const auto rows = missedRows(*map, SearchSensor::Camera, poseFrom({-2.0, 0.0, 0.0}, 0, 0, 0));
    ASSERT_GE(rows.size(), 1U);
    EXPECT_EQ(rows[0].number, 1);
    EXPECT_TRUE(rows[0].area.endsWith("m²")) << rows[0].area.toStdString();
    EXPECT_FALSE(rows[0].where.isEmpty());
    EXPECT_TRUE(missedRows(*map, SearchSensor::Camera, std::nullopt)[0].where.isEmpty());
    const QString text = searchedText(*map, SearchSensor::Camera);
    EXPECT_TRUE(text.contains("%") && text.contains("m²") && text.startsWith("Camera")) << text.toStdString();
    EXPECT_TRUE(searchedText(*nothing, SearchSensor::Camera).contains("No floor"));

    MissedModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.setRows(rows);
    EXPECT_EQ(model.rowCount(), static_cast<int>(rows.size()));
    EXPECT_EQ(model.index(0, MissedModel::Area).data().toString(), rows[0].area);
    EXPECT_EQ(model.rowAt(rows[0].inMap + Eigen::Vector3d(0.3, 0.0, 0.0), 0.75), 0);
    EXPECT_EQ(model.rowAt({100.0, 0.0, 0.0}, 0.75), -1);
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    model.setRows(missedRows(*map, SearchSensor::Camera, poseFrom({0.0, 1.0, 0.0}, 0, 0, 0)));
    EXPECT_EQ(reset.count(), 0) << "a choice is kept while distances change";
    model.setRows({});
    EXPECT_EQ(model.row(0), nullptr);
}

}  // namespace
}  // namespace leitstand::test
