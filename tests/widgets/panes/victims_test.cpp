#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include "core/event/candidate_sample.h"
#include "core/mission/state/find_state.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/models/victims/tag_choices.h"
#include "widgets/painting/theme.h"
#include "widgets/victims/victim_form.h"
#include "widgets/victims/victims_panel.h"

namespace leitstand::test {
namespace {

using Kind = FindSample::Kind;

std::vector<VictimRow> rows() {
    VictimRow first, second, sign, candidate;
    first = {{Kind::Victim, 1U},    0,   "V1", "victim", "confirmed", "3.2 m, 40° left",
             "heat 33 °C · motion", true};
    second = {{Kind::Victim, 2U},       0, "V2", "victim", "unconfirmed", "12 m, behind",
              "CO₂ 1800 ppm · no sound"};
    second.tone = Tone::Attention;
    sign = {{Kind::Hazard, 1U}, 0, "H1", "hazard", "confirmed", "0.8 m, ahead", "flammable", true};
    candidate = {{Kind::Victim, 0U}, 4, "V?", "victim", "candidate 82 %", "5.1 m, 25° right", "heat 31 °C"};
    candidate.tone = Tone::Muted;
    return {first, second, sign, candidate};
}

FindSample victim() {
    FindSample victim;
    victim.number = 2;
    victim.heat = {VictimSign::State::Present, "face", 33.4};
    victim.sound.state = VictimSign::State::Absent;
    victim.situation = "void";
    victim.tag = "R-17";
    return victim;
}

class VictimPanes : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
    [[nodiscard]] QString named(const char* what) const {
        return QStringLiteral("victims_%1_%2")
            .arg(QString::fromLatin1(what),
                 GetParam() == Theme::Dark ? QStringLiteral("dark") : QStringLiteral("light"));
    }
};

TEST_P(VictimPanes, HintsOfTheFormAreNeverCut) {
    VictimForm form;
    form.show(victim());
    for (const int width : {300, 320, 420, 700}) {
        static_cast<void>(pictureOf(form, {width, 420}, named("hints")));
        for (const PaintedText& one : paintedTexts(form)) {
            // Those of words end with dots of their own, after a blank.
            const QString text = QString(one.text).remove(QStringLiteral(" …"));
            EXPECT_FALSE(text.contains(QChar(0x2026))) << width << ": " << one.text.toStdString();
        }
    }
    const auto hints = form.findChildren<QLineEdit*>();
    EXPECT_TRUE(std::any_of(hints.begin(), hints.end(), [](const QLineEdit* one) {
        return one->placeholderText() == QStringLiteral("whole body, arm, hand …");
    })) << "where there is room all words are there";
}

TEST_P(VictimPanes, TheListIsReadWhole) {
    VictimsPanel panel;
    panel.show(rows());
    const QImage shown = pictureOf(panel, {560, 220}, named("list"));
    EXPECT_GT(countOf(shown, coloursOf(GetParam()).attention), 0) << "one is not confirmed";
    panel.show({});
    EXPECT_EQ(countOf(pictureOf(panel, {560, 220}, named("calm")), coloursOf(GetParam()).attention), 0);
}

TEST_P(VictimPanes, TheFormShowsWhatIsKnown) {
    VictimForm form;
    form.show(victim());
    (void)pictureOf(form, {420, 360}, named("form"));
    EXPECT_TRUE(form.isEnabled());
}

INSTANTIATE_TEST_SUITE_P(Themes, VictimPanes, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& one) { return one.param == Theme::Dark ? "Dark" : "Light"; });

TEST(VictimsPanel, AChoiceStaysWhileRowsComeAndGo) {
    VictimsPanel panel;
    panel.show(rows());
    panel.choose({Kind::Victim, 2U});
    ASSERT_TRUE(panel.chosen());
    EXPECT_EQ(panel.chosen()->name, QStringLiteral("V2"));
    auto fewer = rows();
    fewer.erase(fewer.begin());
    panel.show(fewer);
    ASSERT_TRUE(panel.chosen());
    EXPECT_EQ(panel.chosen()->name, QStringLiteral("V2"));
}

TEST(VictimsPanel, AReviewTellsWhenAndWhatWasDiscarded) {
    VictimsPanel panel(nullptr, VictimsPanel::Use::Review);
    auto all = rows();
    all.pop_back();
    all[1].discarded = true;
    all[1].tone = Tone::Muted;
    all[1].since = QStringLiteral("12:04:31");
    panel.show(all);
    const auto* model = panel.findChild<QTableView*>()->model();
    EXPECT_EQ(model->headerData(2, Qt::Horizontal).toString(), QStringLiteral("Found"));
    EXPECT_EQ(model->index(1, 2).data().toString(), QStringLiteral("12:04:31"));
    for (int column = 0; column < model->columnCount(); ++column)
        EXPECT_EQ(model->index(1, column).data(ToneRole).toInt(), static_cast<int>(Tone::Muted));
    (void)pictureOf(panel, {420, 200}, QStringLiteral("victims_review"));
}

TEST(VictimForm, ToldAtOnceWhatIsChangedAndNothingElse) {
    VictimForm form;
    form.show(victim());
    QSignalSpy edited(&form, &VictimForm::edited);
    form.show(victim());
    EXPECT_EQ(edited.count(), 0) << "showing is no edit";
    const auto boxes = form.findChildren<QComboBox*>();
    boxes[0]->setCurrentIndex(0);
    const auto before = edited.count();
    for (QComboBox* box : boxes) {
        if (box->accessibleName() == QStringLiteral("Sound")) box->setCurrentIndex(2);
    }
    ASSERT_EQ(edited.count(), before + 1);
    const auto reported = edited.back().at(0).value<FindSample>();
    EXPECT_EQ(reported.sound.state, VictimSign::State::Present);
    EXPECT_EQ(reported.heat.value, 33.4) << "a value that was not touched is not rounded";
    EXPECT_EQ(reported.tag, "R-17");
}

TEST(VictimForm, AnEditIsNotTakenBackByTheMissionFromBeforeIt) {
    VictimForm form;
    form.show(victim());
    const auto box = [&](const char* name) {
        for (QComboBox* one : form.findChildren<QComboBox*>()) {
            if (one->accessibleName() == QLatin1String(name)) return one;
        }
        return static_cast<QComboBox*>(nullptr);
    };
    QSignalSpy edited(&form, &VictimForm::edited);
    box("Situation")->setCurrentIndex(1);
    form.show(victim());  // the mission does not know of it yet
    box("Sound")->setCurrentIndex(2);
    ASSERT_EQ(edited.count(), 2);
    EXPECT_EQ(edited[1].at(0).value<FindSample>().situation, "surface");
    FindSample newer = victim();
    newer.stamp += std::chrono::seconds(1);
    form.show(newer);
    EXPECT_EQ(box("Situation")->currentIndex(), 3) << "as the mission has it now";
}

TEST(VictimForm, WhatIsBeingTypedStaysWhenTheMissionGoesOn) {
    VictimForm form;
    form.show(victim());
    form.resize(420, 360);
    form.QWidget::show();
    QLineEdit* tag = nullptr;
    for (QLineEdit* line : form.findChildren<QLineEdit*>()) {
        if (line->accessibleName() == QStringLiteral("Tag")) tag = line;
    }
    ASSERT_NE(tag, nullptr);
    form.activateWindow();
    tag->setFocus();
    ASSERT_TRUE(QTest::qWaitFor([&] { return tag->hasFocus(); }));
    tag->clear();
    QTest::keyClicks(tag, QStringLiteral("K-4"));
    FindSample newer = victim();
    newer.text = "said elsewhere";
    newer.stamp += std::chrono::seconds(1);
    form.show(newer);
    EXPECT_EQ(tag->text(), QStringLiteral("K-4"));
    QSignalSpy edited(&form, &VictimForm::edited);
    QTest::keyClick(tag, Qt::Key_Return);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_EQ(edited[0].at(0).value<FindSample>().tag, "K-4");
    EXPECT_EQ(edited[0].at(0).value<FindSample>().text, "said elsewhere");
}

TEST(VictimForm, IsFilledInWithoutAMouse) {
    VictimForm form;
    form.show(victim());
    form.resize(420, 360);
    form.QWidget::show();
    form.activateWindow();
    QSignalSpy edited(&form, &VictimForm::edited);
    form.nextField(1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return form.focusWidget() != nullptr; }));
    form.change(1);
    form.change(1);
    ASSERT_EQ(edited.count(), 2);
    EXPECT_EQ(edited[1].at(0).value<FindSample>().form.state, VictimSign::State::Present);
    FindSample sign;
    sign.kind = Kind::Hazard;
    sign.number = 1;
    form.show(sign);
    form.nextField(1);
    EXPECT_EQ(form.focusWidget()->accessibleName().toStdString(), "Tag") << "a sign has no signs of life";
}

/// A form as somebody has it who holds a pad.
class FormByPad : public testing::Test {
protected:
    FormByPad() {
        m_form.setTags({QStringLiteral("R-17"), QStringLiteral("R-18")});
        m_form.show(victim());
        m_form.resize(420, 360);
        m_form.QWidget::show();
        m_form.activateWindow();
        EXPECT_TRUE(QTest::qWaitFor([this] { return m_form.isActiveWindow(); }));
    }
    [[nodiscard]] QLineEdit& goTo(const QString& name) {
        for (int i = 0; i < 40; ++i) {
            m_form.nextField(1);
            auto* field = qobject_cast<QLineEdit*>(m_form.focusWidget());
            if (field != nullptr && field->accessibleName() == name) return *field;
        }
        throw std::runtime_error("there is no field " + name.toStdString());
    }
    [[nodiscard]] FindSample reported() const { return m_edited.last().at(0).value<FindSample>(); }

    VictimForm m_form;
    QSignalSpy m_edited{&m_form, &VictimForm::edited};
};

TEST_F(FormByPad, WordsAndValuesAreChosen) {
    (void)goTo(QStringLiteral("Motion, in words"));
    for (const char* word : {"waving", "breathing", "", "waving"}) {
        ASSERT_TRUE(m_form.change(1));
        EXPECT_EQ(reported().motion.text, word);
    }
    QLineEdit& heat = goTo(QStringLiteral("Heat, measured"));
    heat.clear();
    ASSERT_TRUE(m_form.change(1));
    EXPECT_EQ(reported().heat.value, 34.0) << "where skin is";
    ASSERT_TRUE(m_form.change(1));
    EXPECT_EQ(reported().heat.value, 35.0);
    for (int i = 0; i < 8; ++i) ASSERT_TRUE(m_form.change(1));
    EXPECT_EQ(reported().heat.value, 25.0) << "round and round";
    QLineEdit& tag = goTo(QStringLiteral("Tag"));
    tag.clear();
    ASSERT_TRUE(m_form.change(1));
    ASSERT_TRUE(m_form.change(1));
    EXPECT_EQ(reported().tag, "R-18") << "a code that was read";
    (void)goTo(QStringLiteral("Remarks"));
    ASSERT_TRUE(m_form.change(1));
    EXPECT_EQ(reported().text, "beside a wall");
}

TEST_F(FormByPad, WhatWasTypedIsNotLost) {
    QLineEdit& tag = goTo(QStringLiteral("Tag"));
    tag.setText(QStringLiteral("illegible, begins with K"));
    EXPECT_FALSE(m_form.change(1));
    EXPECT_EQ(tag.text(), QStringLiteral("illegible, begins with K"));
}

TEST_F(FormByPad, WhatIsBeingTypedIsFiledWhenTheWindowCloses) {
    QLineEdit& tag = goTo(QStringLiteral("Tag"));
    tag.selectAll();
    QTest::keyClicks(&tag, QStringLiteral("Anna"));
    m_form.close();
    EXPECT_EQ(reported().tag, "Anna");
}

TEST(TagChoices, AreCodesThatWereReadTheNearestFirst) {
    MissionState mission;
    using Status = FindSample::Status;
    const auto code = [&](std::uint32_t number, double x, const char* tag, Status status) {
        FindSample one;
        one.kind = Kind::Code;
        one.number = number;
        one.positionInMap = {x, 0, 0};
        one.tag = tag;
        one.status = status;
        mission.finds.edit()[{Kind::Code, number}].victim = one;
    };
    code(1, 5.0, "far", Status::Confirmed);
    code(2, 1.0, "near", Status::Hypothesis);
    code(3, 0.1, "none", Status::Discarded);
    CandidateSample candidate;
    candidate.id = 1;
    candidate.positionInMap = {2.0, 0, 0};
    candidate.cues = {{.kind = "code", .text = "believed"}, {.kind = "code", .text = "near"}};
    mission.candidates.edit()[1].candidate = candidate;
    EXPECT_EQ(tagChoices(mission, FindSample()), QStringList({"near", "believed", "far"}));
}

}  // namespace
}  // namespace leitstand::test
