#pragma once

#include <array>

#include <QDialog>

#include "core/robot/samples/victim_sample.h"

class QComboBox;
class QLineEdit;
class QPlainTextEdit;

namespace leitstand {

/// The form of a find: what its finder judged of it, to be corrected. Not modal; what it does not show stays
/// as it is.
class FindForm final : public QDialog {
    Q_OBJECT
public:
    explicit FindForm(const VictimSample& find, QWidget* parent = nullptr);

    /// As the form has it now.
    [[nodiscard]] VictimSample find() const;

signals:
    void corrected(const leitstand::VictimSample& find);  ///< and is to be kept so

private:
    struct SignFields {
        QComboBox* state = nullptr;
        QLineEdit* text = nullptr;
    };
    VictimSample m_find;
    QComboBox *m_status, *m_situation, *m_area;
    QLineEdit* m_tag;
    QPlainTextEdit* m_text;
    std::array<SignFields, 5> m_signs;  ///< form, motion, heat, sound, CO2
};

}  // namespace leitstand
