#include "widgets/models/review/comparison_rows.h"

#include <optional>

#include <QCoreApplication>

#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::Comparison)
};

const QString None = QStringLiteral("–");

QString millimetres(double metres) {
    if (metres >= 1.0) return Texts::tr("%1 m").arg(numberText(metres, 2));
    return Texts::tr("%1 mm").arg(millimetresText(metres));
}

QString ofTwo(const QString& mean, const QString& most) {
    return Texts::tr("%1, at most %2", "mean and largest").arg(mean, most);
}

template <class T, class Text>
QString optionalText(const std::optional<T>& value, Text text) {
    return value ? text(*value) : None;
}

void addTruth(TextTable& table, const MapComparison& whole) {
    if (!whole.recorded.truth && !whole.again.truth) return;
    const auto add = [&](const QString& name, const QString& hint, auto text) {
        table.rows.push_back(
            {{name, optionalText(whole.recorded.truth, text), optionalText(whole.again.truth, text)}, hint});
    };
    add(Texts::tr("Off the truth"),
        Texts::tr("Root mean square of the robots' positions at the key scans, after the map was turned and "
                  "shifted to fit the recorded truth best"),
        [](const TrajectoryError& error) { return millimetres(error.position); });
    add(Texts::tr("Turned off the truth"), Texts::tr("The same of their attitudes"),
        [](const TrajectoryError& error) { return degreesText(error.rotation); });
    if (!whole.recorded.finds && !whole.again.finds) return;
    const auto addFinds = [&](const QString& name, const QString& hint, auto text) {
        table.rows.push_back(
            {{name, optionalText(whole.recorded.finds, text), optionalText(whole.again.finds, text)}, hint});
    };
    addFinds(
        Texts::tr("Victims found"),
        Texts::tr("True victims that were filed, each find counting for one; missed: those that were not; "
                  "false: finds within %1 m of no victim, or of one that was filed already")
            .arg(numberText(FoundReach, 0)),
        [](const FindsError& error) {
            return Texts::tr("%1, missed %2, false %3", "victims found")
                .arg(error.found())
                .arg(error.missed)
                .arg(error.wrong);
        });
    addFinds(Texts::tr("Victims off the truth"),
             Texts::tr("From each victim that was found to where it truly is, seen from above"),
             [](const FindsError& error) {
                 return error.found() == 0 ? None : ofTwo(millimetres(error.mean), millimetres(error.worst));
             });
}

}  // namespace

TextTable figuresOf(const MapComparison& whole) {
    const MapFigures &recorded = whole.recorded, &again = whole.again;
    const QString scans = countText(whole.scans.size());
    const auto number = [](int count) { return countText(static_cast<std::size_t>(count)); };
    const auto metres = [](double length) { return Texts::tr("%1 m").arg(numberText(length, 2)); };
    TextTable table;
    table.header = {Texts::tr("Figure"), Texts::tr("As recorded"), Texts::tr("Registered again")};
    table.rows = {
        {{Texts::tr("Key scans"), scans, scans}, Texts::tr("Those that were not set aside")},
        {{Texts::tr("Uncertain"), number(recorded.uncertain), number(again.uncertain)},
         Texts::tr("Scans of which the registration was not sure")},
        {{Texts::tr("Set aside"), number(whole.rejected), None},
         Texts::tr("Rejected or rewound by the operator; they are not registered again")},
        {{Texts::tr("Residual"), millimetres(recorded.rms), millimetres(again.rms)},
         Texts::tr("Mean over scans: root mean square distance to the key scan before, of points that have a "
                   "partner within 10 cm")},
        {{Texts::tr("Overlap"), percentText(recorded.overlap), percentText(again.overlap)},
         Texts::tr("Mean over scans: share of points that have such a partner")},
        {{Texts::tr("Path"), metres(recorded.path), metres(again.path)},
         Texts::tr("Way of the robots from key scan to key scan")},
        {{Texts::tr("Moved"), None, ofTwo(millimetres(whole.meanMoved), millimetres(whole.mostMoved))},
         Texts::tr("How far scans are from where they were recorded, mean and largest")},
        {{Texts::tr("Turned"), None, ofTwo(degreesText(whole.meanTurned), degreesText(whole.mostTurned))},
         Texts::tr("The same of their attitudes")},
        {{Texts::tr("Time taken"), None,
          optionalText(again.seconds,
                       [](double seconds) { return Texts::tr("%1 s").arg(numberText(seconds, 1)); })},
         Texts::tr("Of registering all scans; live, it was spread over the mission")},
    };
    addTruth(table, whole);
    return table;
}

TextTable scansOf(const MapComparison& whole) {
    TextTable table;
    table.header = {Texts::tr("Scan"),
                    Texts::tr("Residual"),
                    Texts::tr("again", "residual of a scan"),
                    Texts::tr("Overlap"),
                    Texts::tr("again", "overlap of a scan"),
                    Texts::tr("Moved"),
                    Texts::tr("Turned"),
                    Texts::tr("State")};
    const auto rms = [](const ScanFit& fit) { return millimetres(fit.rms); };
    const auto overlap = [](const ScanFit& fit) { return percentText(fit.overlap); };
    for (const ComparedScan& one : whole.scans) {
        const QString state = one.uncertainAgain      ? Texts::tr("uncertain again")
                              : one.uncertainRecorded ? Texts::tr("was uncertain")
                                                      : Texts::tr("certain");
        table.rows.push_back({{QStringLiteral("%1 %2").arg(othersText(one.robot)).arg(one.id),
                               optionalText(one.fitRecorded, rms), optionalText(one.fitAgain, rms),
                               optionalText(one.fitRecorded, overlap), optionalText(one.fitAgain, overlap),
                               millimetres(distanceBetween(one.recorded, one.again)),
                               degreesText(angleBetween(one.recorded, one.again)), state}});
    }
    return table;
}

QString movedText(const MapComparison& whole) {
    return Texts::tr("moved %1 at most").arg(millimetres(whole.mostMoved));
}

QString comparedText(const MapComparison& whole) {
    return Texts::tr("%1 key scans registered again: moved %2 at most")
        .arg(countText(whole.scans.size()), millimetres(whole.mostMoved));
}

}  // namespace leitstand
