#include "widgets/models/victims/victim_choices.h"

#include <QCoreApplication>

namespace leitstand {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::VictimChoices)
};

}  // namespace

std::vector<VictimChoice> situationChoices() {
    return {{"", Texts::tr("unknown")},
            {"surface", Texts::tr("surface: lies open")},
            {"trapped", Texts::tr("trapped: partly covered")},
            {"void", Texts::tr("void: in a hollow")},
            {"entombed", Texts::tr("entombed: covered")}};
}

std::vector<VictimChoice> areaChoices() {
    return {{"", Texts::tr("unknown")},
            {"yellow", Texts::tr("yellow")},
            {"orange", Texts::tr("orange")},
            {"red", Texts::tr("red")}};
}

std::vector<SignField> signFields() {
    return {{&FindSample::form,
             Texts::tr("Form"),
             {},
             {Texts::tr("whole body"), Texts::tr("arm"), Texts::tr("hand")}},
            {&FindSample::motion, Texts::tr("Motion"), {}, {Texts::tr("waving"), Texts::tr("breathing")}},
            {&FindSample::heat,
             Texts::tr("Heat"),
             Texts::tr("°C"),
             {Texts::tr("face"), Texts::tr("hand")},
             {.usual = 34.0, .step = 1.0, .least = 25.0, .most = 42.0}},
            {&FindSample::sound, Texts::tr("Sound"), {}, {Texts::tr("calling"), Texts::tr("tapping")}},
            {&FindSample::co2,
             Texts::tr("CO₂"),
             Texts::tr("ppm"),
             {Texts::tr("rising"), Texts::tr("steady")},
             {.usual = 1000.0, .step = 250.0, .least = 500.0, .most = 5000.0}}};
}

QString hintText(const QStringList& words, bool more) {
    const QString text = words.join(Texts::tr(", ", "between words"));
    return more ? Texts::tr("%1 …", "what one may write: waving, breathing …").arg(text) : text;
}

QStringList remarkChoices() {
    return {Texts::tr("beside a wall"),   Texts::tr("in a corner"), Texts::tr("behind a door"),
            Texts::tr("under a table"),   Texts::tr("in a box"),    Texts::tr("the way is narrow"),
            Texts::tr("the way is steep")};
}

QString signStateText(VictimSign::State state) {
    switch (state) {
        case VictimSign::State::Unknown:
            return Texts::tr("unknown");
        case VictimSign::State::Absent:
            return Texts::tr("absent");
        case VictimSign::State::Present:
            return Texts::tr("present");
    }
    return {};
}

}  // namespace leitstand
