#include <gmock/gmock.h>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>

#include "tests/app/window/window_page.h"
#include "widgets/scans/registration_panel.h"

namespace leitstand {
namespace {

using test::WindowPage;
using test::WindowTest;
using testing::ElementsAre;

class RegistrationTest : public WindowTest {};

void type(QLineEdit& edit, const QString& text) {
    edit.setFocus();
    edit.selectAll();
    QTest::keyClicks(&edit, text);
}

TEST_F(RegistrationTest, RegisteringAgainWithOtherSettingsKeepsTicksAndChangesFigures) {
    WindowPage page;
    page.openAndWait({drive()});
    page.clickTickBox(0);
    page.find<QComboBox>("minimizer").setFocus();
    page.press(Qt::Key_Home);
    EXPECT_EQ(page.find<QComboBox>("minimizer").currentText().toStdString(), "Points · SVD");
    type(page.find<QLineEdit>("distances"), QStringLiteral("1.5, 0.5"));
    auto& iterations = page.find<QDoubleSpinBox>("iterations");
    iterations.setFocus();
    iterations.selectAll();
    QTest::keyClicks(&iterations, QStringLiteral("2"));
    QTest::keyClick(&iterations, Qt::Key_Return);
    page.click("registerAgain");
    EXPECT_FALSE(page.window().idle());
    page.waitUntilShown();
    EXPECT_LE(std::stoi(page.cell(1, ScanListModel::Iterations)), 2);
    EXPECT_THAT(page.window().scans().visible(), ElementsAre(false, true, true));
    const RegistrationSettings used = page.window().state().registration;
    EXPECT_EQ(used.minimizer, Minimizer::Svd);
    EXPECT_THAT(used.maxDistances, ElementsAre(1.5, 0.5));
}

TEST_F(RegistrationTest, AScheduleThatMakesNoSenseIsMarkedAndNotTaken) {
    WindowPage page;
    auto& distances = page.find<QLineEdit>("distances");
    type(distances, QStringLiteral("0.5, 1.5"));
    EXPECT_TRUE(distances.property("wrong").toBool());
    EXPECT_THAT(page.window().state().registration.maxDistances, ElementsAre(0.5));
    type(distances, QStringLiteral("1.5, 0.5"));
    EXPECT_FALSE(distances.property("wrong").toBool());
}

TEST_F(RegistrationTest, EpsilonAppliesToApproximateSearchesOnly) {
    WindowPage page;
    auto& search = page.find<QComboBox>("search");
    EXPECT_FALSE(page.find<QWidget>("epsilon").isEnabled());
    search.setFocus();
    page.press(Qt::Key_End);
    EXPECT_EQ(search.currentText().toStdString(), "Forest, a tree per label");
    EXPECT_TRUE(page.find<QWidget>("epsilon").isEnabled());
}

TEST_F(RegistrationTest, DefaultsBringEverySettingBack) {
    WindowState state;
    state.registration.minimizer = Minimizer::Plane;
    state.registration.reduce = 0.0;
    state.registration.reference = Reference::Map;
    WindowPage page(state);
    EXPECT_EQ(page.find<QComboBox>("minimizer").currentText().toStdString(), "Point to plane");
    page.click("defaults");
    const RegistrationSettings settings = page.window().state().registration;
    EXPECT_EQ(settings.minimizer, Minimizer::Gicp);
    EXPECT_DOUBLE_EQ(settings.reduce, RegistrationSettings{}.reduce);
    EXPECT_EQ(settings.reference, Reference::Previous);
}

TEST_F(RegistrationTest, EveryFieldSaysWhatItDoes) {
    WindowPage page;
    auto& panel = page.find<QWidget>("registration");
    for (const char* name : {"minimizer", "search", "epsilon", "distances", "iterations", "reduce", "filter",
                             "guess", "reference", "threads", "registerAgain", "before", "defaults"}) {
        const auto* field = panel.findChild<QWidget*>(QLatin1String(name));
        ASSERT_NE(field, nullptr) << name;
        EXPECT_FALSE(field->toolTip().isEmpty()) << name;
    }
}

}  // namespace
}  // namespace leitstand
