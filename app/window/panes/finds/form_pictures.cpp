#include "app/window/panes/finds/form_pictures.h"

#include <algorithm>
#include <utility>

#include "app/services/finds/freezing.h"
#include "widgets/camera/picture_image.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"
#include "widgets/models/times.h"
#include "widgets/victims/evidence_strip.h"
#include "widgets/victims/victim_form.h"

namespace leitstand {
namespace {

/// The log is opened for each request; pictures that were lost never come into it.
constexpr qint64 AsksAgain = 1000;  ///< [ms]

bool haveSameEvidence(const FindSample& one, const FindSample& other) {
    return one.kind == other.kind && one.number == other.number &&
           std::equal(one.evidence.begin(), one.evidence.end(), other.evidence.begin(), other.evidence.end(),
                      [](const VictimEvidence& a, const VictimEvidence& b) {
                          return a.topic == b.topic && a.sequence == b.sequence && a.stamp == b.stamp;
                      });
}

QString captionOf(const EvidencePicture& picture) {
    const QString of = FormPictures::tr("%1, %2, %3")
                           .arg(othersText(picture.robot), othersText(picture.sensor), wallText(picture.at));
    return picture.hottest ? FormPictures::tr("%1: up to %2 °C").arg(of).arg(numberText(*picture.hottest, 1))
                           : of;
}

}  // namespace

FormPictures::FormPictures(VictimForm& form, const std::filesystem::path& mission)
    : QObject(&form),
      m_form(form),
      m_reader(mission, [this](const FindSample& find, const ReadEvidence& read) {
          QMetaObject::invokeMethod(
              this, [this, find, read] { show(find, read); }, Qt::QueuedConnection);
      }) {}

FormPictures::~FormPictures() = default;

void FormPictures::follow(const std::optional<FindSample>& find) {
    const bool asked = find && m_wanted && haveSameEvidence(*find, *m_wanted);
    // Evidence that was frozen a moment ago is in the log a moment later.
    if (asked && (m_written || !m_answered || m_sinceAsked.elapsed() < AsksAgain)) return;
    if (!find && !m_wanted) return;
    m_wanted = find;
    m_answered = m_written = false;
    m_sinceAsked.start();
    if (asked) return m_reader.want(*find);
    const bool some = find && std::any_of(find->evidence.begin(), find->evidence.end(), isPictureEvidence);
    m_form.setPictures({}, some);
    if (some) m_reader.want(*find);
}

void FormPictures::show(const FindSample& find, const ReadEvidence& read) {
    if (!m_wanted || !haveSameEvidence(find, *m_wanted)) return;
    m_answered = true;
    m_written = read.written;
    std::vector<EvidenceImage> images;
    for (const EvidencePicture& one : read.pictures) {
        const QImage image = imageOf(one.picture);
        if (!image.isNull()) images.push_back({image, captionOf(one)});
    }
    m_form.setPictures(std::move(images), true);
}

}  // namespace leitstand
