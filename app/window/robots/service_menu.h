#pragma once

#include <QObject>

#include "app/window/panes/view_context.h"
#include "core/robot/services/service_description.h"

class QMenu;

namespace leitstand {

/// The menu of services that the operator may call of the selected robot: a Switch has an entry for on and
/// one for off, a Trigger has one.
class ServiceMenu final : public QObject {
    Q_OBJECT
public:
    /// Adds the menu to the commands of robots, unless no robot has such a service.
    ServiceMenu(const ViewContext& context, Station& station);

private:
    void fill();
    void add(const QString& text, const ServiceDescription& service, bool value);

    ViewContext m_context;
    Station& m_station;
    QMenu* m_menu = nullptr;  ///< null: no robot has such a service
};

}  // namespace leitstand
