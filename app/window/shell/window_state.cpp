#include "app/window/shell/window_state.h"

#include <algorithm>
#include <utility>

#include <QSettings>

#include "widgets/models/registration_choices.h"

namespace leitstand {
namespace {

constexpr std::size_t MostRecent = 8;
/// A new number makes layouts of older programs start over.
constexpr int LayoutVersion = 1;

QSettings settingsFile() {
    return {QSettings::IniFormat, QSettings::UserScope, QStringLiteral("leitstand"),
            QStringLiteral("leitstand")};
}

template <class T>
void readNumber(const QSettings& file, const char* key, T low, T high, T& value) {
    bool ok = false;
    const double number = file.value(QLatin1String(key)).toDouble(&ok);
    if (ok && number >= static_cast<double>(low) && number <= static_cast<double>(high)) {
        value = static_cast<T>(number);
    }
}

template <class T>
void readEnum(const QSettings& file, const char* key, T last, T& value) {
    int number = static_cast<int>(value);
    readNumber(file, key, 0, static_cast<int>(last), number);
    value = static_cast<T>(number);
}

template <class T>
void readChoice(const QSettings& file, const char* key, const std::vector<Choice<T>>& choices, T& value) {
    value = valueOf(choices, file.value(QLatin1String(key)).toString()).value_or(value);
}

void readView(const QSettings& file, MapViewSettings& view) {
    readEnum(file, "view/look", MapLook::Top, view.look);
    readEnum(file, "view/colouring", MapColouring::Age, view.colouring);
    readEnum(file, "view/theme", Theme::Light, view.theme);
    readNumber(file, "view/voxel", 0.05, 0.5, view.voxelSize);
}

void readRegistration(const QSettings& file, RegistrationSettings& registration) {
    readChoice(file, "registration/minimizer", minimizerChoices(), registration.minimizer);
    readChoice(file, "registration/search", searchChoices(), registration.search);
    readChoice(file, "registration/filter", filterChoices(), registration.filter);
    readChoice(file, "registration/guess", guessChoices(), registration.guess);
    readChoice(file, "registration/reference", referenceChoices(), registration.reference);
    readNumber(file, "registration/epsilon", 0.0, 10.0, registration.epsilon);
    readNumber(file, "registration/reduce", 0.0, 1.0, registration.reduce);
    readNumber(file, "registration/minRange", 0.0, 10.0, registration.minRange);
    readNumber(file, "registration/maxRange", 0.5, 300.0, registration.maxRange);
    readNumber(file, "registration/iterations", 1, 10'000, registration.maxIterations);
    readNumber(file, "registration/threads", 0, 256, registration.threads);
    const auto distances = parseSchedule(file.value(QStringLiteral("registration/distances")).toString());
    if (distances) registration.maxDistances = *distances;
    if (registration.minRange >= registration.maxRange) {
        registration.minRange = RegistrationSettings{}.minRange;
        registration.maxRange = RegistrationSettings{}.maxRange;
    }
}

void write(QSettings& file, const MapViewSettings& view) {
    file.setValue(QStringLiteral("view/look"), static_cast<int>(view.look));
    file.setValue(QStringLiteral("view/colouring"), static_cast<int>(view.colouring));
    file.setValue(QStringLiteral("view/theme"), static_cast<int>(view.theme));
    file.setValue(QStringLiteral("view/voxel"), view.voxelSize);
}

void write(QSettings& file, const RegistrationSettings& registration) {
    const auto put = [&file](const char* key, const QVariant& value) {
        file.setValue(QLatin1String("registration/") + QLatin1String(key), value);
    };
    put("minimizer", keyOf(minimizerChoices(), registration.minimizer));
    put("search", keyOf(searchChoices(), registration.search));
    put("filter", keyOf(filterChoices(), registration.filter));
    put("guess", keyOf(guessChoices(), registration.guess));
    put("reference", keyOf(referenceChoices(), registration.reference));
    put("epsilon", registration.epsilon);
    put("reduce", registration.reduce);
    put("minRange", registration.minRange);
    put("maxRange", registration.maxRange);
    put("iterations", registration.maxIterations);
    put("threads", registration.threads);
    put("distances", scheduleText(registration.maxDistances));
}

}  // namespace

WindowState loadWindowState() {
    WindowState state;
    const QSettings file = settingsFile();
    if (file.value(QStringLiteral("window/version")).toInt() == LayoutVersion) {
        state.geometry = file.value(QStringLiteral("window/geometry")).toByteArray();
        state.layout = file.value(QStringLiteral("window/layout")).toByteArray();
    }
    state.liveGeometry = file.value(QStringLiteral("live/geometry")).toByteArray();
    state.liveLayout = file.value(QStringLiteral("live/layout")).toString();
    state.language = file.value(QStringLiteral("language")).toString();
    readView(file, state.view);
    readRegistration(file, state.registration);
    for (const QString& entry : file.value(QStringLiteral("recent")).toStringList()) {
        Sources sources;
        for (const QString& path : entry.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            sources.emplace_back(path.toStdString());
        }
        if (!sources.empty() && state.recent.size() < MostRecent) state.recent.push_back(std::move(sources));
    }
    return state;
}

void saveWindowState(const WindowState& state) {
    QSettings file = settingsFile();
    file.setValue(QStringLiteral("window/version"), LayoutVersion);
    file.setValue(QStringLiteral("window/geometry"), state.geometry);
    file.setValue(QStringLiteral("window/layout"), state.layout);
    file.setValue(QStringLiteral("live/geometry"), state.liveGeometry);
    file.setValue(QStringLiteral("live/layout"), state.liveLayout);
    file.setValue(QStringLiteral("language"), state.language);
    write(file, state.view);
    write(file, state.registration);
    QStringList recent;
    for (const Sources& sources : state.recent) {
        QStringList paths;
        for (const auto& path : sources) paths.append(QString::fromStdString(path.string()));
        recent.append(paths.join(QLatin1Char('\n')));
    }
    file.setValue(QStringLiteral("recent"), recent);
}

void remember(std::vector<Sources>& recent, const Sources& sources) {
    Sources absolute;
    for (const auto& path : sources) {
        std::error_code failed;
        const auto full = std::filesystem::absolute(path, failed).lexically_normal();
        absolute.push_back(failed ? path : full);
    }
    recent.erase(std::remove(recent.begin(), recent.end(), absolute), recent.end());
    recent.insert(recent.begin(), std::move(absolute));
    if (recent.size() > MostRecent) recent.resize(MostRecent);
}

}  // namespace leitstand
