#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QProcess>
#include <QString>

namespace leitstand {

/// Settings of simulated robots.
struct DemoSettings {
    QString program;  ///< path of leitstand-robot; empty: the one in the folder of this program
    QString arena = QStringLiteral("yellow");
    int seed = 7;
    int domain = 0;
    QString interface = {};  ///< network card; empty: all
};

/// Runs a simulated Kurt3D and Crawler as separate processes while this object lives. They end with this
/// program, even when it crashes.
class DemoRobots final : public QObject {
    Q_OBJECT
public:
    explicit DemoRobots(const DemoSettings& settings, QObject* parent = nullptr);
    ~DemoRobots() override;

    void start();  ///< starts them; does nothing when they were started

signals:
    /// A robot could not be started, or ended by itself. @p why is in the user's language.
    void failed(const QString& why);

private:
    void start(const QString& kind);

    DemoSettings m_settings;
    std::vector<std::unique_ptr<QProcess>> m_robots;
    bool m_ending = false;
};

}  // namespace leitstand
