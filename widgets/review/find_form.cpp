#include "widgets/review/find_form.h"

#include <utility>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/models/review/find_rows.h"

namespace leitstand {
namespace {

constexpr std::array SignOf = {&VictimSample::form, &VictimSample::motion, &VictimSample::heat,
                               &VictimSample::sound, &VictimSample::co2};

void fill(QComboBox& box, const std::vector<std::string>& words, const std::string& chosen,
          QString (*text)(const std::string&)) {
    for (const std::string& word : words) box.addItem(text(word), QString::fromStdString(word));
    // What another program wrote stays.
    const QString now = QString::fromStdString(chosen);
    if (box.findData(now) < 0) box.addItem(text(chosen), now);
    box.setCurrentIndex(box.findData(now));
}

}  // namespace

FindForm::FindForm(const VictimSample& find, QWidget* parent)
    : QDialog(parent),
      m_find(find),
      m_status(new QComboBox(this)),
      m_situation(new QComboBox(this)),
      m_area(new QComboBox(this)),
      m_tag(new QLineEdit(QString::fromStdString(find.tag), this)),
      m_text(new QPlainTextEdit(QString::fromStdString(find.text), this)) {
    const QString name = QString::fromStdString(nameOf(find.kind, find.number));
    setObjectName(QStringLiteral("findForm"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("%1 – form").arg(name));
    auto* fields = new QFormLayout;
    const auto add = [fields](const QString& title, QWidget* field, const char* id) {
        field->setObjectName(QLatin1String(id));
        field->setAccessibleName(title);
        fields->addRow(title, field);
    };
    m_status->addItems({tr("hypothesis"), tr("confirmed"), tr("discarded")});
    m_status->setCurrentIndex(static_cast<int>(find.status));
    add(tr("Status"), m_status, "status");
    const std::array titles = {tr("Form"), tr("Motion"), tr("Heat"), tr("Sound"), tr("CO₂")};
    if (find.kind == VictimSample::Kind::Victim) {
        for (std::size_t i = 0; i < m_signs.size(); ++i) {
            const VictimSign& sign = find.*SignOf[i];
            auto* both = new QWidget(this);
            auto* row = new QHBoxLayout(both);
            row->setContentsMargins(0, 0, 0, 0);
            m_signs[i].state = new QComboBox(both);
            m_signs[i].state->addItems({tr("unknown"), tr("absent"), tr("present")});
            m_signs[i].state->setCurrentIndex(static_cast<int>(sign.state));
            m_signs[i].state->setAccessibleName(titles[i]);
            m_signs[i].text = new QLineEdit(QString::fromStdString(sign.text), both);
            m_signs[i].text->setAccessibleName(tr("%1 in words").arg(titles[i]));
            m_signs[i].text->setPlaceholderText(tr("in words"));
            row->addWidget(m_signs[i].state);
            row->addWidget(m_signs[i].text, 1);
            fields->addRow(titles[i], both);
        }
        fill(*m_situation, {"", "surface", "trapped", "void", "entombed"}, find.situation, situationText);
        add(tr("Situation"), m_situation, "situation");
        fill(*m_area, {"", "yellow", "orange", "red"}, find.area, areaText);
        add(tr("Area"), m_area, "area");
    } else {
        m_situation->hide();
        m_area->hide();
    }
    add(tr("Tag"), m_tag, "tag");
    m_text->setTabChangesFocus(true);
    m_text->setMaximumHeight(90);
    add(tr("Text"), m_text, "text");
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        emit corrected(this->find());
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* rows = new QVBoxLayout(this);
    rows->addLayout(fields);
    auto* kept = new QLabel(tr("Kept as a new entry; what was recorded stays as it is."), this);
    kept->setProperty("muted", true);
    kept->setWordWrap(true);
    rows->addWidget(kept);
    rows->addWidget(buttons);
}

VictimSample FindForm::find() const {
    VictimSample find = m_find;
    find.status = static_cast<VictimSample::Status>(m_status->currentIndex());
    if (find.status != VictimSample::Status::Discarded) find.mergedInto = 0;
    find.tag = m_tag->text().toStdString();
    find.text = m_text->toPlainText().toStdString();
    if (find.kind != VictimSample::Kind::Victim) return find;
    for (std::size_t i = 0; i < m_signs.size(); ++i) {
        VictimSign& sign = find.*SignOf[i];
        sign.state = static_cast<VictimSign::State>(m_signs[i].state->currentIndex());
        sign.text = m_signs[i].text->text().toStdString();
    }
    find.situation = m_situation->currentData().toString().toStdString();
    find.area = m_area->currentData().toString().toStdString();
    return find;
}

}  // namespace leitstand
