#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QProcess>
#include <QString>

namespace leitstand {

/// Settings of simulated robots.
struct DemoSettings {
    QString program;  ///< path of leitstand-robot; empty: it is in the folder of this program
    QString arena = QStringLiteral("yellow");
    int seed = 7;
    int domain = 0;
    QString interface = {};  ///< network card; empty: all
};

/// Runs a simulated Kurt3D and Crawler as separate processes while this object exists. They end with this
/// program, even if it crashes.
class DemoRobots final : public QObject {
    Q_OBJECT
public:
    explicit DemoRobots(const DemoSettings& settings, QObject* parent = nullptr);
    ~DemoRobots() override;

    void start();  ///< starts them; does nothing when they were already started

signals:
    /// A robot could not be started, or has ended. @p why: in the user's language.
    void failed(const QString& why);

private:
    void start(const QString& kind);

    DemoSettings m_settings;
    std::vector<std::unique_ptr<QProcess>> m_robots;
    bool m_ending = false;
};

}  // namespace leitstand
