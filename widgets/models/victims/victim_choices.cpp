#include "widgets/models/victims/victim_choices.h"

#include <QCoreApplication>

namespace leitstand {
namespace {

struct Say {
    Q_DECLARE_TR_FUNCTIONS(leitstand::VictimChoices)
};

}  // namespace

std::vector<VictimChoice> situationChoices() {
    return {{"", Say::tr("unknown")},
            {"surface", Say::tr("surface: lies open")},
            {"trapped", Say::tr("trapped: partly covered")},
            {"void", Say::tr("void: in a hollow")},
            {"entombed", Say::tr("entombed: covered")}};
}

std::vector<VictimChoice> areaChoices() {
    return {{"", Say::tr("unknown")},
            {"yellow", Say::tr("yellow")},
            {"orange", Say::tr("orange")},
            {"red", Say::tr("red")}};
}

std::vector<SignField> signFields() {
    return {
        {&VictimSample::form, Say::tr("Form"), {}, {Say::tr("whole body"), Say::tr("arm"), Say::tr("hand")}},
        {&VictimSample::motion, Say::tr("Motion"), {}, {Say::tr("waving"), Say::tr("breathing")}},
        {&VictimSample::heat,
         Say::tr("Heat"),
         Say::tr("°C"),
         {Say::tr("face"), Say::tr("hand")},
         {.usual = 34.0, .step = 1.0, .least = 25.0, .most = 42.0}},
        {&VictimSample::sound, Say::tr("Sound"), {}, {Say::tr("calling"), Say::tr("tapping")}},
        {&VictimSample::co2,
         Say::tr("CO₂"),
         Say::tr("ppm"),
         {Say::tr("rising"), Say::tr("steady")},
         {.usual = 1000.0, .step = 250.0, .least = 500.0, .most = 5000.0}}};
}

QString hintText(const QStringList& words, bool more) {
    const QString text = words.join(Say::tr(", ", "between words"));
    return more ? Say::tr("%1 …", "what one may write: waving, breathing …").arg(text) : text;
}

QStringList remarkChoices() {
    return {Say::tr("beside a wall"),   Say::tr("in a corner"), Say::tr("behind a door"),
            Say::tr("under a table"),   Say::tr("in a box"),    Say::tr("the way is narrow"),
            Say::tr("the way is steep")};
}

QString signStateText(VictimSign::State state) {
    switch (state) {
        case VictimSign::State::Unknown:
            return Say::tr("unknown");
        case VictimSign::State::Absent:
            return Say::tr("absent");
        case VictimSign::State::Present:
            return Say::tr("present");
    }
    return {};
}

}  // namespace leitstand
