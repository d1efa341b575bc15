#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>

#include "app/window/panes/view_context.h"
#include "core/base/time.h"
#include "widgets/models/live/readings/reading_rows.h"

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
