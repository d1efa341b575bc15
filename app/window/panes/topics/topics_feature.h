#pragma once

#include <map>

#include <QObject>
#include <QTimer>

#include "app/services/domain/seen_topic.h"
#include "app/window/panes/view_context.h"

namespace leitstand {

class TopicsPanel;

/// All topics of the domain ("topics"), for the engineer: what is there, how often it comes, what is in it.
class TopicsFeature final : public QObject {
    Q_OBJECT
public:
    explicit TopicsFeature(const LiveContext& context);

    [[nodiscard]] QWidget& pane() const;

private:
    void list();   ///< lists the topics
    void watch();  ///< watches the chosen topic while the pane is visible
    void show();   ///< shows what came on it

    LiveContext m_context;
    TopicsPanel* m_panel;
    std::map<QString, SeenTopic> m_seen;  ///< by name
    SeenTopic m_watched;                  ///< as it was when it was subscribed
    QTimer m_lists, m_shows;
};

}  // namespace leitstand
