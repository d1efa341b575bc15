#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/event/victim_sample.h"
#include "widgets/models/victims/victim_choices.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace leitstand {

class EvidenceStrip;
struct EvidenceImage;

/// The form of one victim or other find: signs of life, situation, tag, area, text. What is changed is told
/// at once; there is no button to forget. By keyboard: Tab and arrows; by pad: nextField(), change().
class VictimForm final : public QWidget {
    Q_OBJECT
public:
    explicit VictimForm(QWidget* parent = nullptr);
    ~VictimForm() override;

    /// Shows @p find as it is now; what is being typed stays. Empty: none is chosen.
    void show(const std::optional<VictimSample>& find);
    using QWidget::show;

    /// The next (or, negative, previous) field gets the focus.
    void nextField(int step);
    /// What its tag may be: change() goes through them.
    void setTags(const QStringList& tags) { m_tags = tags; }
    /// The field that has the focus gets its next (previous) choice, word or value; false: it has none, or
    /// what was typed there would be lost.
    bool change(int step);

    /// The pictures that show the find; @p awaited: there are some, which are read yet.
    void setPictures(std::vector<EvidenceImage> pictures, bool awaited = false);

    [[nodiscard]] QSize sizeHint() const override;
    /// So wide that no field is cut, whatever its language.
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void edited(const leitstand::VictimSample& find);
    void done();  ///< the operator has filled in what there was

protected:
    void hideEvent(QHideEvent* event) override;  ///< what was being typed counts, also when a window closes

private:
    struct Sign {
        SignField field;
        QComboBox* state;
        QLineEdit *text, *value;
    };
    [[nodiscard]] bool changeLine(QLineEdit& line, int step);
    [[nodiscard]] bool changeValue(const Sign& sign, int step);
    void addHead(QVBoxLayout& rows);
    void addSigns(QGridLayout& grid);
    void addRest(QGridLayout& grid);
    [[nodiscard]] QLabel* label(const QString& text, QWidget* field);
    void read();
    void setEnabledParts(bool on);
    /// @p hints: what one may write into it; @p more: and much else.
    [[nodiscard]] QLineEdit* line(const QString& name, const QStringList& hints, bool more = false);

    std::optional<VictimSample> m_find;
    std::optional<Time>
        m_edited;  ///< stamp of the entry that an edit was based on, until there is a newer one
    bool m_showing = false;
    QLabel* m_title;
    EvidenceStrip* m_pictures;
    QWidget* m_grid = nullptr;  ///< with all fields
    std::vector<Sign> m_signs;
    QStringList m_tags;
    QComboBox *m_situation, *m_area;
    QLineEdit *m_tag, *m_text;
    std::vector<QWidget*> m_fields;  ///< in the order of Tab
};

}  // namespace leitstand
