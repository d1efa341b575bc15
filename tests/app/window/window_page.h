#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <QAbstractButton>
#include <QImage>
#include <QPoint>
#include <QTableView>
#include <QTest>

#include "app/window/scans/main_window.h"
#include "app/window/shell/window_state.h"
#include "tests/support/temporary_folder.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {

/// The window as an operator sees and uses it: found by names, moved by clicks and keys.
class WindowPage {
public:
    explicit WindowPage(const WindowState& state = {});
    ~WindowPage();
    WindowPage(const WindowPage&) = delete;
    WindowPage& operator=(const WindowPage&) = delete;

    [[nodiscard]] MainWindow& window() { return *m_window; }
    [[nodiscard]] MapView& map() { return m_window->mapView(); }

    /// Opens @p sources and waits until all is registered and drawn.
    void openAndWait(const Sources& sources);
    /// Waits until nothing is worked on and the map is drawn; fails the test after a minute.
    void waitUntilShown();

    [[nodiscard]] QTableView& scans();
    /// Clicks the tick box of @p row.
    void clickTickBox(int row);
    [[nodiscard]] std::string cell(int row, int column);
    /// What the label @p name says.
    [[nodiscard]] std::string label(const char* name);
    [[nodiscard]] QAction& action(const char* name);
    /// Clicks the button @p name with the mouse.
    void click(const char* name);
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// The picture on screen.
    [[nodiscard]] QImage picture();
    /// Any widget by type and name.
    template <class T>
    [[nodiscard]] T& find(const char* name) {
        T* found = m_window->findChild<T*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
        return *found;
    }

private:
    std::unique_ptr<MainWindow> m_window;
};

/// Waits until @p condition holds; false after a minute.
template <class Condition>
[[nodiscard]] bool eventually(Condition condition) {
    return QTest::qWaitFor(condition, 60'000);
}

/// A test with a drive of small scans on disk and settings of its own.
class WindowTest : public testing::Test {
protected:
    void SetUp() override;

    /// Writes @p count scans into the folder "room" and returns it.
    [[nodiscard]] std::filesystem::path drive(int count = 3);

    TemporaryFolder m_folder;
};

}  // namespace leitstand::test
