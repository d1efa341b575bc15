#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <QTest>

#include "app/window/review/review_window.h"
#include "app/window/source/review_bridge.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {

/// The review of a mission, writeMinute() unless told otherwise, as an operator sees and uses it.
class ReviewPage : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;
    virtual void writeMission();  ///< into m_mission
    /// A window on the same review, as after a change of language.
    void openWindow();

    template <class Holds>
    [[nodiscard]] static bool soon(Holds holds) {
        return QTest::qWaitFor(holds, 60'000);
    }
    void goTo(double seconds);
    [[nodiscard]] bool stands(double seconds) const;
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
    [[nodiscard]] std::string label(const char* name) const;
    template <class T>
    [[nodiscard]] T& find(const char* name) const {
        T* found = m_window->findChild<T*>(QLatin1String(name));
        if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
        return *found;
    }
    /// The text of a cell of the list of finds.
    [[nodiscard]] std::string found(int row, int column) const;
    [[nodiscard]] int finds() const;  ///< rows of it
    /// For people: a picture of the window in the folder LEITSTAND_PICTURES.
    void lookAt(const QString& name);

    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
    std::unique_ptr<ReviewBridge> m_bridge;
    std::unique_ptr<ReviewWindow> m_window;
};

}  // namespace leitstand::test
