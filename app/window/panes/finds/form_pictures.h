#pragma once

#include <filesystem>
#include <optional>

#include <QElapsedTimer>
#include <QObject>

#include "app/services/finds/evidence_reader.h"
#include "core/event/find_sample.h"

namespace leitstand {

class VictimForm;

/// Reads the pictures in a find's evidence from the mission's log, and shows them in the find's form.
class FormPictures final : public QObject {
    Q_OBJECT
public:
    FormPictures(VictimForm& form, const std::filesystem::path& mission);
    ~FormPictures() override;

    /// Shows the pictures of @p find, which the form shows now; empty: none. Call regularly, since the find
    /// may change, and pictures may be logged later.
    void follow(const std::optional<FindSample>& find);

private:
    void show(const FindSample& find, const ReadEvidence& read);

    VictimForm& m_form;
    std::optional<FindSample> m_wanted;  ///< find whose pictures are shown or requested
    bool m_answered = false, m_written = false;
    QElapsedTimer m_sinceAsked;
    EvidenceReader m_reader;  ///< the last member, so that its thread ends first
};

}  // namespace leitstand
