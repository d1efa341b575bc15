#include <algorithm>

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QTableView>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/station/station_streams.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "tests/app/live/live_page.h"
#include "widgets/link/link_pane.h"
#include "widgets/preflight/preflight_page.h"

namespace leitstand::test {
namespace {

class LinkAndPreflight : public LivePage {
protected:
    [[nodiscard]] double rate(const char* topic) const {
        const LinkStatus link = robot().link;
        const StreamStatus* stream = link.stream(topic);
        return stream == nullptr ? 0.0 : stream->rate;
    }
    void keep(QWidget& widget, const QString& name) const {
        const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
        if (!folder.isEmpty()) widget.grab().save(folder + "/" + name + ".png");
    }
};

TEST_F(LinkAndPreflight, TThinsTheLinkAndThePreflightPageTellsHowThingsAre) {
    static constexpr const char* Right = "/kurt3d/right/image/compressed";
    // Of ten pictures a second, a busy machine makes and shows fewer; a thin link lets under two through.
    static constexpr double Whole = 3.0;  // [Hz]
    ASSERT_TRUE(soon([&] { return rate(Right) > Whole; }));
    QLabel* const badge = m_window->findChild<QLabel*>("thinBadge");
    ASSERT_NE(badge, nullptr);
    EXPECT_FALSE(badge->isVisible());
    ThinSettings settings;
    settings.budget = 1.0;
    station().streams().setThin(settings);
    press(Qt::Key_T);
    EXPECT_TRUE(badge->isVisible());
    EXPECT_TRUE(soon([&] { return rate(Right) < 2.0; })) << "the other camera gives way";
    EXPECT_GT(rate("/kurt3d/points"), 0.5) << "scans stay, in longer slices";

    QAction* const visible = m_window->panes().visibility(QStringLiteral("link"));
    if (!visible->isChecked()) visible->trigger();
    auto* const pane = m_window->findChild<LinkPane*>();
    ASSERT_TRUE(soon([&] { return pane->table().rowCount() > 20; })) << "both robots' streams";
    lookAt("link");
    press(Qt::Key_T);
    EXPECT_FALSE(badge->isVisible());
    EXPECT_TRUE(soon([&] { return rate(Right) > Whole; }));

    press(Qt::Key_F9);
    auto* const page = m_window->findChild<PreflightPage*>();
    ASSERT_TRUE(soon([&] { return page->isVisible() && page->list().rowCount() > 12; }));
    const auto& checks = page->list().checks();
    EXPECT_EQ(worstOf(checks), CheckState::Attention) << "brakes are not tested, nothing fails";
    EXPECT_TRUE(std::any_of(checks.begin(), checks.end(), [](const PreflightCheck& one) {
        return one.kind == PreflightCheck::Kind::Sound || one.kind == PreflightCheck::Kind::SoundNone;
    })) << "whether alarms are heard is told";
    keep(*page->window(), QStringLiteral("live_preflight"));
}

}  // namespace
}  // namespace leitstand::test
