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

    /// Shows the present state of @p find; text that is being typed is kept. Empty: none is selected.
    void show(const std::optional<FindSample>& find);
    using QWidget::show;

    /// Focuses the next field, or the previous one when @p step is negative.
    void nextField(int step);
    /// Sets the tags that change() steps through.
    void setTags(const QStringList& tags) { m_tags = tags; }
    /// Sets the focused field to its next choice, word or value; to the previous one if @p step is negative.
    /// Returns false if the field has none, or if typed text would be lost.
    bool change(int step);

    /// Sets the pictures of the find. @p awaited: whether pictures exist that are still being read.
    void setPictures(std::vector<EvidenceImage> pictures, bool awaited = false);

    [[nodiscard]] QSize sizeHint() const override;
    /// Wide enough that no field is cut in any language.
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void edited(const leitstand::FindSample& find);
    void done();  ///< the operator closed the form

protected:
    void hideEvent(QHideEvent* event) override;  ///< also applies typed text when a window closes

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
    /// @p hints: suggested words. @p more: whether other words are possible, too.
    [[nodiscard]] QLineEdit* line(const QString& name, const QStringList& hints, bool more = false);

    std::optional<FindSample> m_find;
    std::optional<Time>
        m_edited;  ///< stamp of the entry on which an edit is based, until a newer one is shown
    bool m_showing = false;
    QLabel* m_title;
    EvidenceStrip* m_pictures;
    QWidget* m_grid = nullptr;  ///< contains all fields
    std::vector<Sign> m_signs;
    QStringList m_tags;
    QComboBox *m_situation, *m_area;
    QLineEdit *m_tag, *m_text;
    std::vector<QWidget*> m_fields;  ///< in tab order
};

}  // namespace leitstand
