#include "app/window/live/demo_robots.h"

#include <csignal>

#include <QCoreApplication>
#include <QDir>
#include <QProcessEnvironment>

#include <sys/prctl.h>
#include <sys/resource.h>

namespace leitstand {
namespace {

constexpr int Nice = 3;
constexpr int Patience = 2'000;  ///< time for a robot to end on request [ms]

/// Returns the last line of a program's output, as the reason why it ended.
QString lastLine(const QByteArray& reported) {
    const QList<QByteArray> lines = reported.trimmed().split('\n');
    return lines.isEmpty() ? QString() : QString::fromUtf8(lines.last());
}

}  // namespace

DemoRobots::DemoRobots(const DemoSettings& settings, QObject* parent)
    : QObject(parent), m_settings(settings) {
    if (m_settings.program.isEmpty())
        m_settings.program = QDir(QCoreApplication::applicationDirPath()).filePath("leitstand-robot");
}

DemoRobots::~DemoRobots() {
    m_ending = true;
    for (const auto& robot : m_robots) {
        if (robot->state() != QProcess::NotRunning) ::kill(static_cast<pid_t>(robot->processId()), SIGINT);
    }
    for (const auto& robot : m_robots) {
        if (!robot->waitForFinished(Patience)) robot->kill();
        robot->waitForFinished(Patience);
    }
}

void DemoRobots::start() {
    if (!m_robots.empty()) return;
    for (const char* kind : {"kurt3d", "crawler"}) start(QString::fromLatin1(kind));
}

void DemoRobots::start(const QString& kind) {
    m_robots.push_back(std::make_unique<QProcess>());
    QProcess* robot = m_robots.back().get();
    robot->setProgram(m_settings.program);
    QStringList arguments = {kind,
                             "--arena",
                             m_settings.arena,
                             "--seed",
                             QString::number(m_settings.seed),
                             "--domain",
                             QString::number(m_settings.domain)};
    if (!m_settings.interface.isEmpty()) arguments += {"--interface", m_settings.interface};
    robot->setArguments(arguments);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const QString& variable : environment.keys())
        if (variable.startsWith(QLatin1String("ROS_"))) environment.remove(variable);
    robot->setProcessEnvironment(environment);
    robot->setProcessChannelMode(QProcess::MergedChannels);
    robot->setChildProcessModifier([] {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        // A real robot has computers of its own: this one serves the operator first.
        (void)::setpriority(PRIO_PROCESS, 0, Nice);
    });
    connect(robot, &QProcess::errorOccurred, this, [this, robot](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart) return;
        emit failed(tr("%1 cannot be started: %2").arg(robot->program(), robot->errorString()));
    });
    connect(robot, &QProcess::finished, this, [this, robot, kind](int code) {
        if (m_ending) return;
        emit failed(tr("The simulated %1 has ended (%2): %3")
                        .arg(kind, QString::number(code), lastLine(robot->readAll())));
    });
    robot->start();
}

}  // namespace leitstand
