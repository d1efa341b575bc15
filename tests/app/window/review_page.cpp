#include "tests/app/window/review_page.h"

#include <QLabel>
#include <QTableView>

#include "app/services/layouts/layout_book.h"
#include "app/window/review/timeline_feature.h"
#include "tests/app/review/written_mission.h"
#include "tests/app/window_size.h"
#include "tests/support/places.h"
#include "widgets/timeline/timeline_bar.h"

namespace leitstand::test {

void ReviewPage::writeMission() {
    WrittenMission mission(m_mission);
    writeMinute(mission);
}

void ReviewPage::SetUp() {
    writeMission();
    m_bridge = ReviewBridge::open(m_mission).value();
    openWindow();
}

void ReviewPage::openWindow() {
    m_window.reset();
    m_window = std::make_unique<ReviewWindow>(
        *m_bridge, MapViewSettings{},
        LayoutBook(m_folder / "layouts", sourceFolder() + "/resources/layouts"));
    m_window->resize(windowSize());
    m_window->show();
    m_window->activateWindow();  // keys are of the active window
    ASSERT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
    ASSERT_TRUE(soon([this] { return m_bridge->reviewed() != nullptr; }));
}

void ReviewPage::TearDown() {
    m_window.reset();
    m_bridge.reset();
}

void ReviewPage::goTo(double seconds) {
    m_bridge->player().seek(WrittenMission::at(seconds));
    ASSERT_TRUE(stands(seconds));
}

bool ReviewPage::stands(double seconds) const {
    return soon([&] { return m_bridge->reviewed()->now == WrittenMission::at(seconds); });
}

void ReviewPage::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(&m_window->timeline().bar(), key, modifiers);
}

std::string ReviewPage::label(const char* name) const {
    const auto* const found = m_window->findChild<QLabel*>(QLatin1String(name));
    return found == nullptr ? "there is no such label" : found->text().toStdString();
}

std::string ReviewPage::found(int row, int column) const {
    return find<QTableView>("finds").model()->index(row, column).data().toString().toStdString();
}

int ReviewPage::finds() const {
    return find<QTableView>("finds").model()->rowCount();
}

void ReviewPage::lookAt(const QString& name) {
    const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
    if (folder.isEmpty()) return;
    EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
    m_window->grab().save(folder + "/review_" + name + ".png");
}

}  // namespace leitstand::test
