#include "robots/simulation/stock/stock_services.h"

#include <utility>

namespace leitstand::simulation {

Result<std::unique_ptr<StockServices>> StockServices::create(Node& node, const RobotDescription& robot) {
    auto services = std::make_unique<StockServices>();
    StockServices& its = *services;
    for (const ServiceDescription& service : robot.services) {
        const ServiceFacts* const facts = serviceFacts(service.type);
        if (facts != nullptr && facts->kind == ServiceKind::Navigate) continue;  // StockNavigation
        const bool eStop = facts != nullptr && facts->kind == ServiceKind::Switch && service.stop;
        ServiceServer::Serve serve;
        if (eStop) {
            serve = [&its, on = *service.stop](const ServiceRequest& request) {
                its.m_off = request.value == on;
                return ServiceAnswer{true, its.m_off ? "E-stop is on" : "E-stop is off"};
            };
        } else if (service.name.ends_with("/stop_camera") || service.name.ends_with("/start_camera")) {
            serve = [&its, stop = service.name.ends_with("/stop_camera")](const ServiceRequest&) {
                its.m_blind = stop;
                return ServiceAnswer{true, ""};
            };
        } else {
            serve = [](const ServiceRequest&) { return ServiceAnswer{true, ""}; };
        }
        auto server = ServiceServer::create(node, service.name, service.type, std::move(serve));
        if (!server) return server.error();
        its.m_servers.push_back(std::move(server).value());
    }
    return services;
}

}  // namespace leitstand::simulation
