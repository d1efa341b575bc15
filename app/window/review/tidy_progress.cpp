#include "app/window/review/tidy_progress.h"

#include <exception>
#include <stop_token>
#include <string>
#include <thread>

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>

#include "app/services/review/map_tidying.h"
#include "core/base/words.h"

namespace leitstand {
namespace {

constexpr int Whole = 100;  ///< per cent

std::string done(const std::filesystem::path& mission, MapTidying what, const Progress& progress) {
    TidySettings settings;
    settings.version = QCoreApplication::applicationVersion().toStdString();
    try {
        if (what == MapTidying::TakeBack) {
            const auto undone = untidyMap(mission, settings.version);
            return undone ? translate("leitstand::Station", "the map is as it was before it was tidied")
                          : undone.error().text;
        }
        const auto tidied = tidyMap(mission, settings, progress);
        return tidied ? tidiedText(*tidied) : tidied.error().text;
    } catch (const std::exception& problem) {  // no memory
        return problem.what();
    }
}

}  // namespace

QString tidyInFront(const std::filesystem::path& mission, MapTidying what) {
    QProgressDialog dialog;
    dialog.setObjectName(QStringLiteral("tidying"));
    dialog.setWindowTitle(QCoreApplication::applicationName());
    dialog.setLabelText(QCoreApplication::translate("leitstand::ReviewWindow",
                                                    "The map is being tidied. The review opens again then."));
    dialog.setRange(0, Whole);
    dialog.setMinimumDuration(0);
    dialog.setAutoClose(false);
    dialog.setAutoReset(false);
    dialog.setValue(0);
    dialog.show();
    std::string text;
    bool over = false;  // of this thread
    QEventLoop loop;
    const auto hop = [&dialog](auto call) {
        QMetaObject::invokeMethod(&dialog, std::move(call), Qt::QueuedConnection);
    };
    std::jthread thread([&](const std::stop_token& stop) {
        const auto show = [&](double share) {
            hop([&dialog, share] { dialog.setValue(static_cast<int>(Whole * share)); });
        };
        text = done(mission, what, {show, stop});
        hop([&] {
            over = true;
            loop.quit();
        });
    });
    QObject::connect(&dialog, &QProgressDialog::canceled, &loop, [&thread] { thread.request_stop(); });
    while (!over) loop.exec();  // a window that was the last one and closed may end it, too
    thread.join();
    return QString::fromStdString(text);
}

}  // namespace leitstand
