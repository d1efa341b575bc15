#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/event/find_sample.h"
#include "widgets/models/victims/victim_choices.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace leitstand {

class EvidenceStrip;
struct EvidenceImage;

/// The form of one victim or other find: signs of life, situation, tag, area, text. Changes are emitted at
/// once, without a button to confirm them. Keyboard: Tab and arrows; pad: nextField(), change().
class VictimForm final : public QWidget {
    Q_OBJECT
public:
    explicit VictimForm(QWidget* parent = nullptr);
    ~VictimForm() override;

    /// Shows the current state of @p find; text being typed stays. Empty: none is chosen.
    void show(const std::optional<FindSample>& find);
    using QWidget::show;

    /// Focuses the next field, or the previous one when @p step is negative.
    void nextField(int step);
    /// Sets the tags that change() steps through.
    void setTags(const QStringList& tags) { m_tags = tags; }
    /// Sets the focused field to the next choice, word or value; to the previous one when @p step is
    /// negative. Returns false when the field has none, or when typed text would be lost.
    bool change(int step);

    /// Sets the pictures of the find. @p awaited: pictures exist and are still being read.
    void setPictures(std::vector<EvidenceImage> pictures, bool awaited = false);

    [[nodiscard]] QSize sizeHint() const override;
    /// Wide enough that no field is cut, in any language.
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void edited(const leitstand::FindSample& find);
    void done();  ///< the operator closed the form

protected:
    void hideEvent(QHideEvent* event) override;  ///< applies typed text, also when a window closes

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
    /// @p hints: suggested words; @p more: other words are possible, too.
    [[nodiscard]] QLineEdit* line(const QString& name, const QStringList& hints, bool more = false);

    std::optional<FindSample> m_find;
    std::optional<Time>
        m_edited;  ///< stamp of the entry that an edit is based on, until a newer one is shown
    bool m_showing = false;
    QLabel* m_title;
    EvidenceStrip* m_pictures;
    QWidget* m_grid = nullptr;  ///< holds all fields
    std::vector<Sign> m_signs;
    QStringList m_tags;
    QComboBox *m_situation, *m_area;
    QLineEdit *m_tag, *m_text;
    std::vector<QWidget*> m_fields;  ///< in tab order
};

}  // namespace leitstand
