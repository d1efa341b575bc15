#include "app/window/scans/file_commands.h"

#include <utility>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QWidget>

#include "app/services/offline/scan_session.h"
#include "app/window/commands/make_action.h"

namespace leitstand {
namespace {

QString pathText(const std::filesystem::path& path) {
    const QString text = QString::fromStdString(path.string());
    const QString home = QDir::homePath();
    return text.startsWith(home + QLatin1Char('/')) ? QLatin1Char('~') + text.mid(home.size()) : text;
}

QString sourcesText(const Sources& sources) {
    const QString first = pathText(sources.front());
    if (sources.size() == 1) return first;
    return FileCommands::tr("%1 and %2 more").arg(first).arg(sources.size() - 1);
}

Sources sourcesOf(const QStringList& files) {
    Sources sources;
    for (const QString& file : files) sources.emplace_back(file.toStdString());
    return sources;
}

}  // namespace

FileCommands::FileCommands(QWidget& window, std::vector<Sources> recent, std::function<QImage()> picture)
    : QObject(&window), m_window(window), m_recent(std::move(recent)), m_picture(std::move(picture)) {
    m_openFiles = makeAction({"openFiles", tr("&Open scans…"), tr("Adds scan files to the map"),
                              QKeySequence(Qt::CTRL | Qt::Key_O)},
                             this);
    m_openFolder = makeAction({"openFolder", tr("Open &folder…"), tr("Adds all scans of a folder to the map"),
                               QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)},
                              this);
    m_recentMenu = new QMenu(tr("Open &recent"), &window);
    m_recentMenu->setObjectName(QStringLiteral("recent"));
    m_save =
        makeAction({"savePicture", tr("&Save picture…"), tr("Saves the map as it is shown, in full detail"),
                    QKeySequence(Qt::CTRL | Qt::Key_S)},
                   this);
    m_close = makeAction(
        {"closeScans", tr("&Close scans"), tr("Empties the map"), QKeySequence(Qt::CTRL | Qt::Key_W)}, this);
    m_quit = makeAction({"quit", tr("&Quit"), {}, QKeySequence(Qt::CTRL | Qt::Key_Q)}, this);
    connect(m_openFiles, &QAction::triggered, this, &FileCommands::chooseFiles);
    connect(m_openFolder, &QAction::triggered, this, &FileCommands::chooseFolder);
    connect(m_save, &QAction::triggered, this, &FileCommands::choosePicture);
    connect(m_close, &QAction::triggered, this, &FileCommands::closeRequested);
    connect(m_quit, &QAction::triggered, &window, &QWidget::close);
    fillRecent();
    setMapEmpty(true);
}

void FileCommands::fill(QMenu& menu) {
    menu.addActions({m_openFiles, m_openFolder});
    menu.addMenu(m_recentMenu);
    menu.addSeparator();
    menu.addActions({m_save, m_close});
    menu.addSeparator();
    menu.addAction(m_quit);
}

void FileCommands::open(const Sources& sources) {
    if (sources.empty()) return;
    remember(m_recent, sources);
    fillRecent();
    emit openRequested(sources);
}

void FileCommands::setMapEmpty(bool empty) {
    m_save->setEnabled(!empty);
    m_close->setEnabled(!empty);
}

void FileCommands::chooseFiles() {
    auto* dialog = new QFileDialog(&m_window, tr("Open scans"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFiles);
    QStringList patterns;
    for (const std::string& ending : scanEndings())
        patterns += QLatin1Char('*') + QString::fromStdString(ending);
    dialog->setNameFilters({tr("Scans (%1)").arg(patterns.join(QLatin1Char(' '))), tr("All files (*)")});
    connect(dialog, &QFileDialog::filesSelected, this,
            [this](const QStringList& files) { open(sourcesOf(files)); });
    dialog->open();
}

void FileCommands::chooseFolder() {
    auto* dialog = new QFileDialog(&m_window, tr("Open a folder of scans"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& folder) { open(sourcesOf({folder})); });
    dialog->open();
}

void FileCommands::choosePicture() {
    auto* dialog = new QFileDialog(&m_window, tr("Save the map's picture"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("PNG pictures (*.png)"), tr("JPEG pictures (*.jpg)")});
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(tr("map.png"));
    connect(dialog, &QFileDialog::fileSelected, this, &FileCommands::savePicture);
    dialog->open();
}

void FileCommands::savePicture(const QString& file) {
    if (m_picture().save(file)) {
        emit pictureSaved(file);
    } else {
        emit failed(tr("%1: the picture could not be written").arg(file));
    }
}

void FileCommands::fillRecent() {
    m_recentMenu->clear();
    int number = 0;
    for (const Sources& sources : m_recent) {
        QString text = sourcesText(sources);
        text.replace(QLatin1Char('&'), QLatin1String("&&"));
        QAction* entry = m_recentMenu->addAction(QStringLiteral("&%1  %2").arg(++number).arg(text));
        connect(
            entry, &QAction::triggered, this, [this, sources] { open(sources); }, Qt::QueuedConnection);
    }
    m_recentMenu->setEnabled(!m_recent.empty());
    if (m_recent.empty()) return;
    m_recentMenu->addSeparator();
    connect(
        m_recentMenu->addAction(tr("&Forget these")), &QAction::triggered, this,
        [this] {
            m_recent.clear();
            fillRecent();
        },
        Qt::QueuedConnection);
}

}  // namespace leitstand
