#pragma once

#include <filesystem>
#include <optional>

#include <QElapsedTimer>
#include <QObject>

#include "app/services/finds/evidence_reader.h"

namespace leitstand {

class VictimForm;

/// Shows in a form the pictures that its find's evidence names, as they stand in the mission's log.
class FormPictures final : public QObject {
    Q_OBJECT
public:
    FormPictures(VictimForm& form, const std::filesystem::path& mission);
    ~FormPictures() override;

    /// The form shows @p find now; to be told again whenever it may have changed.
    void follow(const std::optional<VictimSample>& find);

private:
    void show(const VictimSample& find, const ReadEvidence& read);

    VictimForm& m_form;
    std::optional<VictimSample> m_wanted;  ///< whose pictures are shown, or asked for
    bool m_answered = false, m_written = false;
    QElapsedTimer m_sinceAsked;
    EvidenceReader m_reader;  ///< last: its thread ends first
};

}  // namespace leitstand
