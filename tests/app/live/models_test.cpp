// A robot that publishes its model is drawn by it, with its joints.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <QAction>
#include <QPushButton>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/robots/measures_feature.h"
#include "core/io/robot/robot_file.h"
#include "tests/app/live/stock_page.h"
#include "tests/support/temporary_folder.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/frames/frame_rows.h"
#include "widgets/models/live/robots/measures.h"
#include "widgets/painting/number_box.h"
#include "widgets/robots/measures_form.h"

namespace leitstand::test {
namespace {

/// The shipped robot in a file of the user's own.
RobotDescription ownCopy(const std::filesystem::path& file) {
    writeText(file, readText(shippedRobot("tracked").file));
    return readRobot(file).value();
}

/// Made before the window, which opens the robot in it.
struct OwnFolder {
    TemporaryFolder own;
};

class ModelsPage : protected OwnFolder, public StockPage {
protected:
    ModelsPage() : StockPage(ownCopy(own / "tracked.yaml")) {}
    /// Pixels of the map in the orange of the model's hull, in any light.
    [[nodiscard]] int orange() const {
        const QImage image = m_window->mapView().grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                const bool is = pixel.red() > 100 && pixel.hsvHue() > 15 && pixel.hsvHue() < 35 &&
                                pixel.hsvSaturation() > 180;
                count += is ? 1 : 0;
            }
        }
        return count;
    }
};

TEST_F(ModelsPage, ARobotIsDrawnByItsModelUntilItIsSwitchedOff) {
    ASSERT_TRUE(soon([&] { return isPlaced(); }));
    EXPECT_TRUE(soon([&] { return orange() > 50; }));
    m_window->layouts().use("drive");
    QTest::qWait(1'500);
    lookAt("model-drive");
    m_window->layouts().use("map");
    lookAt("model-map");
    m_window->commands().find(QStringLiteral("map.followBehind"))->trigger();
    QTest::qWait(1'500);
    lookAt("model-behind");
    QAction* const modelled = m_window->commands().find(QStringLiteral("map.models"));
    modelled->trigger();
    EXPECT_TRUE(soon([&] { return orange() < 50; })) << "a symbol";
    lookAt("model-off");
    modelled->trigger();
    EXPECT_TRUE(soon([&] { return orange() > 50; }));
}

TEST_F(ModelsPage, ItsSizeIsTakenFromTheModelAndWrittenToItsFile) {
    QString robot, file;
    QObject::connect(&m_window->measures(), &MeasuresFeature::fileChanged, m_window.get(),
                     [&](const QString& name, const QString& path) {
                         robot = name;
                         file = path;
                     });
    m_window->commands().find(QStringLiteral("robot.measures"))->trigger();
    auto* const form = m_window->findChild<MeasuresForm*>();
    ASSERT_TRUE(form->isVisible());
    EXPECT_NEAR(form->measures().height, 0.5, 1e-9);
    auto* const fromModel = form->findChild<QPushButton*>(QStringLiteral("fromModel"));
    ASSERT_TRUE(soon([&] { return fromModel->isEnabled(); })) << "the robot's model has come";
    if (const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES"); !folder.isEmpty())
        form->grab().save(folder + QStringLiteral("/measures-file.png"));
    auto* const ahead = form->findChild<NumberBox*>();
    ahead->setFocus();
    ahead->setValue(0.62);
    QTest::keyClick(ahead, Qt::Key_Return);
    EXPECT_NEAR(sidesOf(form->measures().footprint).front, 0.62, 1e-9) << "Enter presses no button";
    fromModel->click();
    EXPECT_GT(form->measures().footprint.size(), 3U);
    const double height = form->measures().height;
    EXPECT_NE(height, 0.5);
    QTest::qWait(200);
    if (const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES"); !folder.isEmpty())
        form->grab().save(folder + QStringLiteral("/measures-model.png"));
    form->findChild<QPushButton*>(QStringLiteral("save"))->click();
    EXPECT_EQ(robot, QStringLiteral("tracked"));
    EXPECT_EQ(file.toStdString(), (own / "tracked.yaml").string());
    EXPECT_FALSE(form->isVisible());
    const auto written = readRobot(file.toStdString());
    ASSERT_TRUE(written) << written.error().text;
    EXPECT_NEAR(written->height, height, 1e-3);
    EXPECT_EQ(written->streams.size(), shippedRobot("tracked").streams.size());
}

TEST_F(ModelsPage, ItsFramesAreATree) {
    m_window->commands().find(QStringLiteral("frames.open"))->trigger();
    auto* const table = m_window->findChild<QTableView*>(QStringLiteral("frames"));
    const auto rowOf = [&](const QString& frame) {
        for (int row = 0; row < table->model()->rowCount(); ++row) {
            if (table->model()->index(row, 0).data().toString().trimmed() == frame) return row;
        }
        return -1;
    };
    ASSERT_TRUE(soon(
        [&] { return rowOf(QStringLiteral("velodyne")) >= 0 && rowOf(QStringLiteral("base_link")) >= 0; }));
    EXPECT_LT(rowOf(QStringLiteral("odom")), rowOf(QStringLiteral("base_link")));
    EXPECT_LT(rowOf(QStringLiteral("base_link")), rowOf(QStringLiteral("velodyne")));
    const auto cell = [&](const char* frame, int column) {
        return table->model()->index(rowOf(QLatin1String(frame)), column).data().toString();
    };
    EXPECT_TRUE(soon([&] { return cell("base_link", FrameRowsModel::Rate).endsWith(QStringLiteral("Hz")); }));
    EXPECT_EQ(cell("velodyne", FrameRowsModel::Rate), QStringLiteral("static"));
    lookAt("frames");
}

}  // namespace
}  // namespace leitstand::test
