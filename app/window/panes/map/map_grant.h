#pragma once

#include <QObject>
#include <QString>

#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

/// Shows which station makes the map, and hands it over to another station that requests it.
class MapGrantFeature final : public QObject {
    Q_OBJECT
public:
    MapGrantFeature(const LiveContext& context, QObject* parent);

private:
    void show();
    void give();

    LiveContext m_context;
    QAction* m_give;
    QString m_maker;  ///< other station that last made the map; empty: this station did
};

}  // namespace leitstand
