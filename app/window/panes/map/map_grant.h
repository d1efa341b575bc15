#pragma once

#include <QObject>
#include <QString>

#include "app/window/panes/view_context.h"

class QAction;

namespace leitstand {

/// Which station makes the map: hands it over to another one that would.
class MapGrantFeature final : public QObject {
    Q_OBJECT
public:
    MapGrantFeature(const LiveContext& context, QObject* parent);

private:
    void show();
    void give();

    LiveContext m_context;
    QAction* m_give;
    QString m_maker;  ///< another station that made the map last; empty: this one did
};

}  // namespace leitstand
