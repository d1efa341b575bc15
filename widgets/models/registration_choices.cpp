#include "widgets/models/registration_choices.h"

#include <algorithm>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace leitstand {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RegistrationSettings)
};

constexpr double SmallestDistance = 0.01, LargestDistance = 10.0;

}  // namespace

std::vector<Choice<SearchMethod>> searchChoices() {
    return {
        {SearchMethod::BruteForce, "brute-force", Texts::tr("Brute force"),
         Texts::tr("Compares every point with every point: exact and very slow (first row of the paper's "
                   "Table 1). Reduce the points first.")},
        {SearchMethod::KdTree, "kd-tree", Texts::tr("k-d tree"),
         Texts::tr("Exact search in an optimised k-d tree (Friedman, Bentley & Finkel 1977).")},
        {SearchMethod::Approximate, "approximate", Texts::tr("Approximate k-d tree"),
         Texts::tr("A k-d tree that may answer a point up to (1 + ε) times as far as the nearest "
                   "(Arya & Mount 1993).")},
        {SearchMethod::Forest, "forest", Texts::tr("Forest, a tree per label"),
         Texts::tr(
             "Floor, wall and ceiling points look for their own kind only, each in an approximate tree of "
             "its own (the paper, section 2.2).")},
    };
}

std::vector<Choice<Minimizer>> minimizerChoices() {
    const auto translated = [](const char* text) {
        return QCoreApplication::translate(MinimizerTexts, text);
    };
    std::vector<Choice<Minimizer>> choices;
    for (const MinimizerRow& row : minimizers())
        choices.push_back({row.minimizer, row.key, translated(row.name), translated(row.hint)});
    return choices;
}

std::vector<Choice<ScanFilter>> filterChoices() {
    return {
        {ScanFilter::None, "none", Texts::tr("None"), Texts::tr("All points go on to the voxels.")},
        {ScanFilter::Median, "median", Texts::tr("Median and reduction"),
         Texts::tr(
             "The paper's filter for organised scans: outliers of a raw scan become the median of their "
             "neighbours, close points are joined.")},
    };
}

std::vector<Choice<GuessSource>> guessChoices() {
    return {
        {GuessSource::Odometry, "odometry", Texts::tr("Odometry"),
         Texts::tr("Each scan starts where the robot's odometry puts it after the scan before.")},
        {GuessSource::Identity, "identity", Texts::tr("Pose of the scan before"),
         Texts::tr(
             "Each scan starts at the registered pose of the scan before: for scans without odometry.")},
    };
}

std::vector<Choice<Reference>> referenceChoices() {
    return {
        {Reference::Previous, "previous", Texts::tr("Previous scan"),
         Texts::tr("Each scan is matched against the one before it.")},
        {Reference::Map, "map", Texts::tr("Whole map"),
         Texts::tr("Each scan is matched against all scans so far (metascan): slower, drifts less.")},
    };
}

std::optional<std::vector<double>> parseSchedule(const QString& text) {
    static const QRegularExpression separators(QStringLiteral("[,;\\s]+"));
    std::vector<double> distances;
    for (const QString& part : text.split(separators, Qt::SkipEmptyParts)) {
        bool number = false;
        const double distance = part.toDouble(&number);
        if (!number || !(distance >= SmallestDistance && distance <= LargestDistance)) return std::nullopt;
        if (!distances.empty() && distance > distances.back()) return std::nullopt;
        distances.push_back(distance);
    }
    if (distances.empty()) return std::nullopt;
    return distances;
}

QString scheduleText(const std::vector<double>& maxDistances) {
    QStringList parts;
    for (const double distance : maxDistances) parts.append(QString::number(distance));
    return parts.join(QStringLiteral(", "));
}

bool sameSettings(const RegistrationSettings& a, const RegistrationSettings& b) {
    const bool samePoses =
        std::equal(a.guessPoses.begin(), a.guessPoses.end(), b.guessPoses.begin(), b.guessPoses.end(),
                   [](const Pose& left, const Pose& right) { return left.matrix() == right.matrix(); });
    return a.reduce == b.reduce && a.filter == b.filter && a.minRange == b.minRange &&
           a.maxRange == b.maxRange && a.search == b.search && a.epsilon == b.epsilon &&
           a.minimizer == b.minimizer && a.maxDistances == b.maxDistances &&
           a.maxIterations == b.maxIterations && a.guess == b.guess && a.reference == b.reference &&
           a.threads == b.threads && samePoses;
}

}  // namespace leitstand
