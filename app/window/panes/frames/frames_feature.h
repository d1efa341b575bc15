#pragma once

#include <QObject>
#include <QTimer>

#include "app/window/panes/view_context.h"

class QWidget;

namespace leitstand {

class FramesPanel;

/// The tf tree of the selected robot ("frames"), for the engineer.
class FramesFeature final : public QObject {
    Q_OBJECT
public:
    explicit FramesFeature(const LiveContext& context);

    [[nodiscard]] QWidget& pane() const;

private:
    void show();

    LiveContext m_context;
    FramesPanel* m_panel;
    QTimer m_shows;
};

}  // namespace leitstand
