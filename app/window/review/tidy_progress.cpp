#include "app/window/review/tidy_progress.h"

#include <exception>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>

#include "app/services/review/map_tidying.h"
#include "core/base/words.h"

namespace leitstand {
namespace {

constexpr int Whole = 100;  ///< per cent

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ReviewWindow)
};

TidyingOutcome outcome(bool moved, const std::string& text) {
    return {moved, QString::fromStdString(text)};
}

TidyingOutcome done(const std::filesystem::path& mission, MapTidying what, const Progress& progress) {
    TidySettings settings;
    settings.version = QCoreApplication::applicationVersion().toStdString();
    try {
        if (what == MapTidying::TakeBack) {
            const auto undone = untidyMap(mission, settings.version);
            if (!undone) return outcome(false, undone.error().text);
            return outcome(true,
                           translate("leitstand::Station", "the map is as it was before it was tidied"));
        }
        const auto tidied = tidyMap(mission, settings, progress);
        if (!tidied) return outcome(false, tidied.error().text);
        return outcome(tidied->moved > 0, tidiedText(*tidied));
    } catch (const std::exception& problem) {  // no memory
        return outcome(false, problem.what());
    }
}

/// Set up to tell how far @p what is.
void prepare(QProgressDialog& dialog, MapTidying what) {
    dialog.setObjectName(QStringLiteral("tidying"));
    dialog.setWindowTitle(QCoreApplication::applicationName());
    dialog.setRange(0, Whole);
    dialog.setMinimumDuration(0);
    dialog.setAutoClose(false);
    dialog.setAutoReset(false);
    dialog.setLabelText(Words::tr("The map is being tidied. The review opens again then."));
    if (what == MapTidying::TakeBack) {
        dialog.setLabelText(Words::tr("The tidying is taken back. The review opens again then."));
        dialog.setCancelButton(nullptr);
    }
    // It stays until the work has ended, also once that was cancelled.
    QObject::disconnect(&dialog, &QProgressDialog::canceled, &dialog, nullptr);
    dialog.setValue(0);
    dialog.show();
}

}  // namespace

TidyingOutcome tidyInFront(const std::filesystem::path& mission, MapTidying what) {
    QProgressDialog dialog;
    prepare(dialog, what);
    TidyingOutcome came;
    bool over = false;  // of this thread
    const auto hop = [&dialog](auto call) {
        QMetaObject::invokeMethod(&dialog, std::move(call), Qt::QueuedConnection);
    };
    std::jthread thread([&](const std::stop_token& stop) {
        const auto show = [&](double share) {
            hop([&dialog, share] { dialog.setValue(static_cast<int>(Whole * share)); });
        };
        came = done(mission, what, {show, stop});
        hop([&over] { over = true; });
    });
    QObject::connect(&dialog, &QProgressDialog::canceled, &dialog, [&] {
        if (what == MapTidying::TakeBack) return;  // that cannot be stopped half-way
        thread.request_stop();
        dialog.setLabelText(Words::tr("Being cancelled…"));
    });
    // Not exec(): once the program was asked to end that returns at once, again and again.
    QEventLoop loop;
    while (!over) loop.processEvents(QEventLoop::WaitForMoreEvents);
    thread.join();
    return came;
}

}  // namespace leitstand
