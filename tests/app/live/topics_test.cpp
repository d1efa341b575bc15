// The pane of topics, on a stock robot with topics that the station records and others.
#include <memory>
#include <string>
#include <vector>

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

#include <gtest/gtest.h>

#include "app/services/station/station.h"
#include "app/services/topics/topic_watch.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "tests/app/live/live_page.h"
#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "widgets/topics/topics_panel.h"

namespace leitstand::test {
namespace {

class TopicsPage : public LivePage {
protected:
    TopicsPage() : LivePage(Robots::None, {shippedRobot("tracked")}) {
        m_robot = std::make_unique<ChildProcess>(
            program("leitstand-robot"),
            std::vector<std::string>{"stock", "tracked", "--domain", std::to_string(m_domain.number()),
                                     "--arena", "yellow", "--seed", "7"});
        m_window->commands().find(QStringLiteral("topics.open"))->trigger();
        m_panel = m_window->findChild<TopicsPanel*>();
        m_topics = m_panel->findChild<QTableView*>(QStringLiteral("topics"));
        m_fields = m_panel->findChild<QTableView*>(QStringLiteral("fields"));
    }
    [[nodiscard]] static QString text(const QTableView& table, int row, int column) {
        return table.model()->index(row, column).data().toString();
    }
    /// The row of @p table whose first column says @p what; -1: none.
    [[nodiscard]] static int rowOf(const QTableView& table, const QString& what) {
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            if (text(table, row, 0).trimmed() == what) return row;
        }
        return -1;
    }
    [[nodiscard]] bool choose(const char* topic) {
        return soon([&] {
            const int row = rowOf(*m_topics, QLatin1String(topic));
            if (row >= 0) m_topics->selectRow(row);
            return row >= 0;
        });
    }
    [[nodiscard]] QString summary() const {
        return m_panel->findChild<QLabel*>(QStringLiteral("topicSummary"))->text();
    }

    std::unique_ptr<ChildProcess> m_robot;
    TopicsPanel* m_panel = nullptr;
    QTableView *m_topics = nullptr, *m_fields = nullptr;
};

TEST_F(TopicsPage, ShowsHowOftenATopicComesWhatIsInItAndPlotsANumber) {
    ASSERT_TRUE(choose("/joint_states"));
    ASSERT_TRUE(soon([&] { return rowOf(*m_fields, QStringLiteral("frame_id")) >= 0; }))
        << summary().toStdString();
    EXPECT_TRUE(soon([&] { return summary().contains(QStringLiteral("Hz")); }));
    EXPECT_TRUE(soon([&] {
        const auto view = station().topicWatch().view();
        return view && view->rate > 10.0 && view->rate < 30.0;
    })) << "20 times a second";
    const int position = rowOf(*m_fields, QStringLiteral("position"));
    ASSERT_GE(position, 0);
    m_fields->scrollTo(m_fields->model()->index(position + 3, 0));
    QTest::mouseClick(m_fields->viewport(), Qt::LeftButton, {},
                      m_fields->visualRect(m_fields->model()->index(position + 3, 0)).center());
    EXPECT_EQ(m_panel->plotted(), QStringLiteral("position[2]"));
    EXPECT_TRUE(soon([&] { return station().topicWatch().plotted().size() > 20; }));
    lookAt("topics");
}

TEST_F(TopicsPage, OfATypeThatNobodyKnowsRateAndLoadAreShown) {
    ASSERT_TRUE(choose("/dynamic_joint_states"));
    EXPECT_TRUE(soon([&] {
        return summary().contains(QStringLiteral("Hz")) &&
               summary().contains(QStringLiteral("is not known here"));
    })) << summary().toStdString();
    EXPECT_EQ(m_fields->model()->rowCount(), 0);
}

TEST_F(TopicsPage, NothingIsSubscribedWhileThePaneIsHidden) {
    ASSERT_TRUE(choose("/odom"));
    ASSERT_TRUE(soon([&] { return station().topicWatch().view().has_value(); }));
    m_window->panes().visibility(QStringLiteral("topics"))->trigger();
    EXPECT_TRUE(soon([&] { return !station().topicWatch().view().has_value(); }));
    m_window->commands().find(QStringLiteral("topics.open"))->trigger();
    EXPECT_TRUE(soon([&] {
        const auto view = station().topicWatch().view();
        return view && view->messages > 0;
    })) << "the same one again";
    auto* const filter = m_panel->findChild<QLineEdit*>(QStringLiteral("topicFilter"));
    filter->setText(QStringLiteral("odometry"));
    EXPECT_EQ(m_topics->model()->rowCount(), 1);
    EXPECT_EQ(text(*m_topics, 0, 0), QStringLiteral("/odom"));
}

}  // namespace
}  // namespace leitstand::test
