#pragma once

#include <functional>
#include <vector>

#include <QImage>
#include <QObject>

#include "app/window/shell/window_state.h"

class QAction;
class QMenu;
class QWidget;

namespace leitstand {

/// The File menu: opening, closing and saving.
class FileCommands final : public QObject {
    Q_OBJECT
public:
    /// Dialogs belong to @p window. @p recent: what was opened before. @p picture: makes the picture that is
    /// saved.
    FileCommands(QWidget& window, std::vector<Sources> recent, std::function<QImage()> picture);

    /// Puts the commands into @p menu.
    void fill(QMenu& menu);
    /// Adds @p sources to the recent ones and requests to open them.
    void open(const Sources& sources);
    [[nodiscard]] const std::vector<Sources>& recent() const { return m_recent; }
    /// Sets whether the map is empty; then closing and saving are disabled.
    void setMapEmpty(bool empty);

signals:
    void openRequested(const leitstand::Sources& sources);
    void closeRequested();
    void pictureSaved(const QString& file);
    void failed(const QString& why);

private:
    void chooseFiles();
    void chooseFolder();
    void choosePicture();
    void savePicture(const QString& file);
    void fillRecent();

    QWidget& m_window;
    std::vector<Sources> m_recent;
    std::function<QImage()> m_picture;
    QAction* m_openFiles;
    QAction* m_openFolder;
    QMenu* m_recentMenu;
    QAction* m_save;
    QAction* m_close;
    QAction* m_quit;
};

}  // namespace leitstand
