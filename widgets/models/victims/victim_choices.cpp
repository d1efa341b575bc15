#include "widgets/models/victims/victim_choices.h"

#include <QCoreApplication>

namespace leitstand {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("leitstand::Victims", text);
}

}  // namespace

std::vector<VictimChoice> situationChoices() {
    return {{"", tr("unknown")},
            {"surface", tr("surface: lies open")},
            {"trapped", tr("trapped: partly covered")},
            {"void", tr("void: in a hollow")},
            {"entombed", tr("entombed: covered")}};
}

std::vector<VictimChoice> areaChoices() {
    return {{"", tr("unknown")}, {"yellow", tr("yellow")}, {"orange", tr("orange")}, {"red", tr("red")}};
}

std::vector<SignField> signFields() {
    return {{&VictimSample::form, tr("Form"), {}, tr("whole body, arm, hand …")},
            {&VictimSample::motion, tr("Motion"), {}, tr("waving, breathing …")},
            {&VictimSample::heat, tr("Heat"), tr("°C"), tr("face, hand …")},
            {&VictimSample::sound, tr("Sound"), {}, tr("calling, tapping …")},
            {&VictimSample::co2, tr("CO₂"), tr("ppm"), tr("rising, steady …")}};
}

QString signStateText(VictimSign::State state) {
    switch (state) {
        case VictimSign::State::Unknown:
            return tr("unknown");
        case VictimSign::State::Absent:
            return tr("absent");
        case VictimSign::State::Present:
            return tr("present");
    }
    return {};
}

}  // namespace leitstand
