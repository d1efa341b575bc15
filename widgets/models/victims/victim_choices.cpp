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
    return {{&VictimSample::form, Say::tr("Form"), {}, Say::tr("whole body, arm, hand …")},
            {&VictimSample::motion, Say::tr("Motion"), {}, Say::tr("waving, breathing …")},
            {&VictimSample::heat, Say::tr("Heat"), Say::tr("°C"), Say::tr("face, hand …")},
            {&VictimSample::sound, Say::tr("Sound"), {}, Say::tr("calling, tapping …")},
            {&VictimSample::co2, Say::tr("CO₂"), Say::tr("ppm"), Say::tr("rising, steady …")}};
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
