#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QProcess>
#include <QString>

namespace leitstand {

/// Where simulated robots are to be.
struct DemoSettings {
    QString program;  ///< leitstand-robot; empty: the one beside this program
    QString arena = QStringLiteral("yellow");
    int seed = 7;
    int domain = 0;
    QString interface = {};  ///< network card; empty: all
};

/// Simulated Kurt3D and Crawler as processes of their own, as long as this object lives; they end with this
/// program, whatever becomes of it.
class DemoRobots final : public QObject {
    Q_OBJECT
public:
    explicit DemoRobots(const DemoSettings& settings, QObject* parent = nullptr);
    ~DemoRobots() override;

    void start();  ///< once; nothing when they run

signals:
    /// A robot could not be started, or ended by itself. In the user's language.
    void failed(const QString& why);

private:
    void start(const QString& kind);

    DemoSettings m_settings;
    std::vector<std::unique_ptr<QProcess>> m_robots;
    bool m_ending = false;
};

}  // namespace leitstand
