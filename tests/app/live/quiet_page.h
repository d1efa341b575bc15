#pragma once

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include "app/window/commands/command_table.h"
#include "tests/app/live/live_page.h"

namespace leitstand::test {

/// The live window on Kurt3D and the Crawler while neither is in the network: what needs no robot.
class QuietPage : public testing::Test {
protected:
    QuietPage() : m_live(openLiveStation(m_folder.path().toStdString(), m_domain.number())) {
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window()));
    }

    template <class Holds>
    [[nodiscard]] static bool soon(Holds holds) {
        return QTest::qWaitFor(holds, 60'000);
    }
    [[nodiscard]] LiveWindow& window() const { return *m_live.window; }
    [[nodiscard]] Station& station() const { return m_live.bridge->station(); }
    [[nodiscard]] QAction& command(const char* id) const {
        QAction* const found = window().commands().find(QLatin1String(id));
        if (found == nullptr) throw std::runtime_error(std::string("there is no ") + id);
        return *found;
    }
    void press(Qt::Key key, Qt::KeyboardModifiers with = {}) { QTest::keyClick(&window(), key, with); }

    const TestDomain m_domain;
    const QTemporaryDir m_folder;
    const LiveStation m_live;
};

}  // namespace leitstand::test
