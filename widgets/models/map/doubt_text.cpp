#include "widgets/models/map/doubt_text.h"

#include <array>

#include <QCoreApplication>
#include <QStringList>

#include "core/event/scan_pose.h"

namespace leitstand {
namespace {

struct DoubtWords {
    ScanDoubt doubt;
    const char *word, *meaning;
};

constexpr std::array<DoubtWords, 8> AllDoubts = {{
    {ScanDoubt::Overlap, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "little overlap"),
     QT_TRANSLATE_NOOP("leitstand::ScanDoubt",
                       "Little overlap: few of its points meet the map. Where it shows new ground, "
                       "accept it if its walls go on in line.")},
    {ScanDoubt::Residual, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "bad fit"),
     QT_TRANSLATE_NOOP("leitstand::ScanDoubt",
                       "Bad fit: points that meet the map lie off it. Retry, or reject it.")},
    {ScanDoubt::Jump, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "jump"),
     QT_TRANSLATE_NOOP(
         "leitstand::ScanDoubt",
         "Jump: it moved otherwise than the wheels say. They may have slipped: look whether walls "
         "double.")},
    {ScanDoubt::Certainty, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "open direction"),
     QT_TRANSLATE_NOOP("leitstand::ScanDoubt",
                       "Open direction: it fits as well when shifted some way, as in a corridor.")},
    {ScanDoubt::Diverged, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "no end"),
     QT_TRANSLATE_NOOP("leitstand::ScanDoubt",
                       "No end: the registration did not settle. Retry with a wider search.")},
    {ScanDoubt::Odometry, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "no odometry"),
     QT_TRANSLATE_NOOP(
         "leitstand::ScanDoubt",
         "No odometry: nobody knows how the robot came there. Retry from a pose that you drag.")},
    {ScanDoubt::Points, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "too few points"),
     QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "Too few points: reject it, the next scan says more.")},
    {ScanDoubt::Guessed, QT_TRANSLATE_NOOP("leitstand::ScanDoubt", "motion partly guessed"),
     QT_TRANSLATE_NOOP(
         "leitstand::ScanDoubt",
         "Motion partly guessed: odometry was missing or late within the scan. Look whether its "
         "walls are bent.")},
}};

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ScanDoubt)
};

}  // namespace

QString doubtText(std::uint8_t doubts) {
    QStringList words;
    for (const DoubtWords& one : AllDoubts) {
        if (has(doubts, one.doubt)) words += Texts::tr(one.word);
    }
    return words.join(QStringLiteral(", "));
}

QString doubtDetails(std::uint8_t doubts) {
    QStringList lines;
    for (const DoubtWords& one : AllDoubts) {
        if (has(doubts, one.doubt)) lines += Texts::tr(one.meaning);
    }
    return lines.join(QLatin1Char('\n'));
}

QString trustText(ScanTrust trust) {
    switch (trust) {
        case ScanTrust::Certain:
            return Texts::tr("certain");
        case ScanTrust::Uncertain:
            return Texts::tr("uncertain ?");
        case ScanTrust::SetAside:
            break;
    }
    return Texts::tr("set aside");
}

Tone toneOf(ScanTrust trust) {
    if (trust == ScanTrust::Uncertain) return Tone::Attention;
    return trust == ScanTrust::SetAside ? Tone::Muted : Tone::Normal;
}

}  // namespace leitstand
