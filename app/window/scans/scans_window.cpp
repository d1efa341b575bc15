#include "app/window/scans/scans_window.h"

#include <QObject>

#include "app/language/language.h"
#include "app/window/scans/main_window.h"
#include "app/window/shell/first_geometry.h"

namespace leitstand {

void showScansWindow(const Sources& scans, const WindowState& state) {
    auto* window = new MainWindow(state);
    window->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(window, &MainWindow::closing, window, [window] {
        // Keeps what only other windows know.
        WindowState now = window->state();
        const WindowState kept = loadWindowState();
        now.language = kept.language;
        now.liveGeometry = kept.liveGeometry;
        now.liveLayout = kept.liveLayout;
        saveWindowState(now);
    });
    QObject::connect(window, &MainWindow::languageWanted, window, [window](const QString& code) {
        WindowState kept = loadWindowState();
        kept.language = code;
        saveWindowState(kept);
        useLanguage(code);
        // The new one first: the program ends with its last window.
        showScansWindow(window->sources(), window->state());
        window->close();
    });
    showAsLeft(*window, state.geometry, state.firstSize);
    if (!scans.empty()) window->open(scans);
}

}  // namespace leitstand
