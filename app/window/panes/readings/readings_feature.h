#pragma once

#include <QObject>
#include <QTimer>

#include "app/window/panes/view_context.h"

namespace leitstand {

class ReadingsPanel;

/// What the selected robot's further sensors say ("readings").
class ReadingsFeature final : public QObject {
    Q_OBJECT
public:
    explicit ReadingsFeature(const ViewContext& context);

    [[nodiscard]] QWidget& pane() const;

private:
    void show();
    void plot();

    ViewContext m_context;
    ReadingsPanel* m_panel;
    QTimer m_shows;
};

}  // namespace leitstand
