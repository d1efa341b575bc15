#include "app/window/shell/work_in_front.h"

#include <stop_token>
#include <thread>
#include <utility>

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>

namespace leitstand {
namespace {

constexpr int Whole = 100;  ///< per cent

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ReviewWindow)
};

/// Sets up @p dialog to show progress.
void prepare(QProgressDialog& dialog, const WorkInFront& look) {
    dialog.setObjectName(look.name);
    dialog.setWindowTitle(QCoreApplication::applicationName());
    dialog.setRange(0, Whole);
    dialog.setMinimumDuration(0);
    dialog.setAutoClose(false);
    dialog.setAutoReset(false);
    dialog.setLabelText(look.label);
    if (!look.cancellable) dialog.setCancelButton(nullptr);
    // It stays until the work has ended, also after a cancellation.
    QObject::disconnect(&dialog, &QProgressDialog::canceled, &dialog, nullptr);
    dialog.setValue(0);
    dialog.show();
}

}  // namespace

void workInFront(const WorkInFront& look, const std::function<void(const Progress&)>& work) {
    QProgressDialog dialog;
    prepare(dialog, look);
    bool over = false;  // used by this thread alone
    const auto hop = [&dialog](auto call) {
        QMetaObject::invokeMethod(&dialog, std::move(call), Qt::QueuedConnection);
    };
    std::jthread thread([&](const std::stop_token& stop) {
        const auto show = [&](double share) {
            hop([&dialog, share] { dialog.setValue(static_cast<int>(Whole * share)); });
        };
        work({show, stop});
        hop([&over] { over = true; });
    });
    QObject::connect(&dialog, &QProgressDialog::canceled, &dialog, [&] {
        if (!look.cancellable) return;
        thread.request_stop();
        dialog.setLabelText(Words::tr("Being cancelled…"));
    });
    // Not exec(): once the program was asked to end, it returns at once every time.
    QEventLoop loop;
    while (!over) loop.processEvents(QEventLoop::WaitForMoreEvents);
    thread.join();
}

}  // namespace leitstand
