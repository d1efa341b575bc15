#include "tests/app/window/window_page.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QSettings>
#include <QTableView>

#include "tests/app/services/scan_folder.h"

namespace leitstand::test {

WindowPage::WindowPage(const WindowState& state) : m_window(std::make_unique<MainWindow>(state)) {
    m_window->show();
    m_window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
}

WindowPage::~WindowPage() = default;

void WindowPage::openAndWait(const Sources& sources) {
    m_window->open(sources);
    waitUntilShown();
}

void WindowPage::waitUntilShown() {
    ASSERT_TRUE(eventually([this] { return m_window->idle() && map().settled(); }));
}

QTableView& WindowPage::scans() {
    return find<QTableView>("scans");
}

void WindowPage::clickTickBox(int row) {
    const QRect cell = scans().visualRect(scans().model()->index(row, ScanListModel::Name));
    QTest::mouseClick(scans().viewport(), Qt::LeftButton, {}, {cell.left() + 10, cell.center().y()});
}

std::string WindowPage::cell(int row, int column) {
    return scans().model()->index(row, column).data().toString().toStdString();
}

std::string WindowPage::label(const char* name) {
    return find<QLabel>(name).text().toStdString();
}

QAction& WindowPage::action(const char* name) {
    return find<QAction>(name);
}

void WindowPage::click(const char* name) {
    QTest::mouseClick(&find<QAbstractButton>(name), Qt::LeftButton);
}

void WindowPage::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QWidget* target = QApplication::focusWidget();
    QTest::keyClick(target != nullptr ? target : m_window.get(), key, modifiers);
}

QImage WindowPage::picture() {
    waitUntilShown();
    return map().grab().toImage();
}

void WindowTest::SetUp() {
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString((m_folder / "config").string()));
}

std::filesystem::path WindowTest::drive(int count) {
    const auto folder = m_folder / "room";
    writeDrive(folder, count);
    return folder;
}

}  // namespace leitstand::test
