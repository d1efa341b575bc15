#include "app/window/panes/topics/topics_feature.h"

#include <chrono>
#include <vector>

#include <QAction>
#include <QMainWindow>

#include "app/services/station/station.h"
#include "app/services/topics/topic_watch.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/pane_docks.h"
#include "widgets/models/others_text.h"
#include "widgets/topics/topics_panel.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds ListEvery(1000), ShowEvery(200);

}  // namespace

TopicsFeature::TopicsFeature(const LiveContext& context)
    : QObject(&context.window), m_context(context), m_panel(new TopicsPanel(&context.window)) {
    m_panel->setObjectName(QStringLiteral("topicsPane"));
    QAction& open =
        m_context.commands.add({.id = QStringLiteral("topics.open"),
                                .menu = CommandMenu::Robot,
                                .text = tr("&Topics of the network"),
                                .hint = tr("Lists all topics, and shows what comes on one of them"),
                                .keys = QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_T)});
    connect(&open, &QAction::triggered, this, [this] { m_context.panes.open(QStringLiteral("topics")); });
    connect(&m_lists, &QTimer::timeout, this, &TopicsFeature::list);
    connect(&m_shows, &QTimer::timeout, this, &TopicsFeature::show);
    connect(m_panel, &TopicsPanel::topicChosen, this, &TopicsFeature::watch);
    connect(m_panel, &TopicsPanel::fieldChosen, this, [this](const QString& path) {
        m_context.station.topicWatch().plot(path.toStdString());
        show();
    });
    connect(m_panel, &TopicsPanel::shownChanged, this, [this](bool shown) {
        if (!shown) {
            m_lists.stop();
            m_shows.stop();
            m_watched = {};
            return m_context.station.topicWatch().end();
        }
        m_lists.start(ListEvery);
        m_shows.start(ShowEvery);
        list();  // and watches what was chosen
    });
}

QWidget& TopicsFeature::pane() const {
    return *m_panel;
}

void TopicsFeature::list() {
    m_seen.clear();
    std::vector<TopicRow> rows;
    for (const SeenTopic& topic : m_context.station.visibleTopics()) {
        if (!topic.name.starts_with('/')) continue;  // of services and actions
        const QString name = othersText(topic.name);
        m_seen.emplace(name, topic);
        QStringList nodes;
        for (const std::string& node : topic.nodes) nodes += othersText(node);
        rows.push_back({name, othersText(topic.type), nodes.join(QStringLiteral(", ")), topic.written,
                        othersText(topic.obstacle)});
    }
    m_panel->showTopics(rows);
    const auto chosen = m_seen.find(m_panel->chosen());
    if (chosen == m_seen.end()) return;
    const SeenTopic& now = chosen->second;
    // It appeared, or somebody else offers it: what was subscribed may not match.
    if (now.name != m_watched.name || now.type != m_watched.type || now.written != m_watched.written ||
        now.qos != m_watched.qos || now.obstacle != m_watched.obstacle)
        watch();
}

void TopicsFeature::watch() {
    const auto chosen = m_seen.find(m_panel->chosen());
    if (chosen == m_seen.end()) {
        m_watched = {};
        return m_context.station.topicWatch().end();
    }
    m_watched = chosen->second;
    if (const auto watched = m_context.station.topicWatch().watch(chosen->second); !watched)
        m_context.notify(QString::fromStdString(watched.error().text));
    m_context.station.topicWatch().plot(m_panel->plotted().toStdString());
    show();
}

void TopicsFeature::show() {
    const auto view = m_context.station.topicWatch().view();
    if (!view) return;
    std::vector<FieldRow> fields;
    QString summary = topicSummary(view->rate, view->megabits, view->age);
    if (view->newest) {
        for (const InspectedField& field : view->newest->fields)
            fields.push_back(
                {othersText(field.path), othersText(field.value), field.depth, field.number.has_value()});
        if (view->newest->cut) summary += tr(" · not all of its fields");
    }
    if (!view->problem.empty()) summary += QLatin1Char('\n') + othersText(view->problem);
    m_panel->showMessage(summary, fields);
    m_panel->showPlot(m_context.station.topicWatch().plotted(), TopicWatch::PlotSpan);
}

}  // namespace leitstand
