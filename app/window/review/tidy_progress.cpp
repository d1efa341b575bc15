#include "app/window/review/tidy_progress.h"

#include <exception>
#include <string>

#include <QCoreApplication>

#include "app/services/review/map_tidying.h"
#include "app/window/shell/work_in_front.h"
#include "core/base/words.h"

namespace leitstand {
namespace {

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
    } catch (const std::exception& problem) {  // out of memory
        return outcome(false, problem.what());
    }
}

}  // namespace

TidyingOutcome tidyInFront(const std::filesystem::path& mission, MapTidying what) {
    TidyingOutcome came;
    const bool takesBack = what == MapTidying::TakeBack;
    workInFront({.name = QStringLiteral("tidying"),
                 .label = takesBack ? Words::tr("The tidying is taken back. The review opens again then.")
                                    : Words::tr("The map is being tidied. The review opens again then."),
                 .cancellable = !takesBack},
                [&](const Progress& progress) { came = done(mission, what, progress); });
    return came;
}

}  // namespace leitstand
