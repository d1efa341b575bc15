#pragma once

#include <filesystem>
#include <vector>

#include <QByteArray>
#include <QSize>
#include <QString>
#include <QStringList>

#include "core/mapping/registration_settings.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// Files and folders that were opened together.
using Sources = std::vector<std::filesystem::path>;

/// What the window stores from one start to the next.
struct WindowState {
    QByteArray geometry;  ///< QWidget::saveGeometry; empty: decided by firstSize
    QSize firstSize{1280, 800};
    QByteArray layout;        ///< QMainWindow::saveState
    QByteArray liveGeometry;  ///< geometry of the live, review and by-hand windows
    QString liveLayout;       ///< name of the live window's layout; empty: "drive"
    QString language;         ///< code of the language; empty: the user's
    MapViewSettings view;
    RegistrationSettings registration;
    std::vector<Sources> recent;  ///< newest first
};

/// Returns the state that was saved last. Values that are missing or make no sense have their defaults.
[[nodiscard]] WindowState loadWindowState();
/// Saves @p state to leitstand/leitstand.ini in the user's XDG configuration folder.
void saveWindowState(const WindowState& state);

/// Puts @p sources, made absolute, at the front of @p recent, and keeps at most eight entries.
void remember(std::vector<Sources>& recent, const Sources& sources);

}  // namespace leitstand
