#include "app/language/language.h"

#include <algorithm>
#include <memory>

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include "core/base/words.h"

static void registerTranslations() {
    Q_INIT_RESOURCE(translations);  // not within a namespace
}

namespace leitstand {
namespace {

/// Translators in use: for our texts and for Qt's own dialogs.
struct Translators {
    std::unique_ptr<QTranslator> own, qt;
    QString code = QStringLiteral("en");
};
Translators& translators() {
    static Translators all;
    return all;
}

std::unique_ptr<QTranslator> installed(const QString& name, const QString& folder) {
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(name, folder)) return nullptr;
    QCoreApplication::installTranslator(translator.get());
    return translator;
}

void remove(std::unique_ptr<QTranslator>& translator) {
    if (translator) QCoreApplication::removeTranslator(translator.get());
    translator.reset();
}

}  // namespace

const std::vector<Language>& languages() {
    static const std::vector<Language> all = {{QStringLiteral("en"), QStringLiteral("English")},
                                              {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                              {QStringLiteral("ja"), QStringLiteral("日本語")}};
    return all;
}

bool useLanguage(const QString& code) {
    registerTranslations();
    setTranslator([](const char* context, const char* text) {
        return QCoreApplication::translate(context, text).toStdString();
    });
    const auto& all = languages();
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const Language& one) { return one.code == code; });
    Translators& now = translators();
    remove(now.own);
    remove(now.qt);
    now.code = known ? code : all.front().code;
    if (now.code == all.front().code) {
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        return known;
    }
    QLocale::setDefault(QLocale(now.code));
    now.qt =
        installed(QStringLiteral("qtbase_") + now.code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    now.own = installed(QStringLiteral("leitstand_") + now.code, QStringLiteral(":/leitstand/translations"));
    return known;
}

QString presentLanguage() {
    return translators().code;
}

QString systemLanguage() {
    const QString code = QLocale::system().name().left(2);
    const auto& all = languages();
    const bool known =
        std::any_of(all.begin(), all.end(), [&](const Language& one) { return one.code == code; });
    return known ? code : all.front().code;
}

}  // namespace leitstand
