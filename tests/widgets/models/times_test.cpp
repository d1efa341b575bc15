#include "widgets/models/times.h"

#include <gtest/gtest.h>
#include <QLocale>

namespace leitstand {
namespace {

struct Written {
    QLocale locale;
    const char* text;
    const char* tenths;
};

class Times : public testing::TestWithParam<Written> {
protected:
    ~Times() override { QLocale::setDefault(m_before); }
    const QLocale m_before;
};

/// Newer versions of Qt write a narrow space before PM.
QString withPlainSpaces(QString text) {
    return text.replace(QChar(0x202F), QLatin1Char(' '));
}

TEST_P(Times, OfTheDayAreWrittenAsTheLanguageDoes) {
    QLocale::setDefault(GetParam().locale);
    EXPECT_EQ(withPlainSpaces(timeOfDayText(QTime(20, 1, 54, 370))), QString::fromUtf8(GetParam().text));
    EXPECT_EQ(withPlainSpaces(timeOfDayText(QTime(20, 1, 54, 370), true)),
              QString::fromUtf8(GetParam().tenths));
}

INSTANTIATE_TEST_SUITE_P(Languages, Times,
                         testing::Values(Written{QLocale(QLocale::English, QLocale::UnitedStates),
                                                 "8:01:54 PM", "8:01:54.3 PM"},
                                         Written{QLocale(QStringLiteral("de")), "20:01:54", "20:01:54,3"},
                                         Written{QLocale(QStringLiteral("ja")), "20:01:54", "20:01:54.3"}),
                         [](const auto& one) { return one.param.locale.name().toStdString(); });

}  // namespace
}  // namespace leitstand
