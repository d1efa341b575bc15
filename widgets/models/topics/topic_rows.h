#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "widgets/models/text_rows_model.h"

namespace leitstand {

/// A topic of the domain.
struct TopicRow {
    QString topic, type;
    QString nodes;         ///< who publishes it, or who reads it
    bool written = false;  ///< whether somebody publishes it
    QString obstacle;      ///< why it cannot be received; empty: it can
    friend bool operator==(const TopicRow&, const TopicRow&) = default;
};

/// Returns those of @p rows that have all words of @p filter in topic, type or nodes, whatever their case.
[[nodiscard]] std::vector<TopicRow> filtered(const std::vector<TopicRow>& rows, const QString& filter);

/// Topics as rows of a table.
class TopicRowsModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Topic, Type, Nodes, Columns };
    using TextRowsModel::TextRowsModel;

    void show(const std::vector<TopicRow>& rows);
    [[nodiscard]] const std::vector<TopicRow>& rows() const { return m_rows; }

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;
    [[nodiscard]] Tone tone(int row, int column) const override;

private:
    std::vector<TopicRow> m_rows;
};

/// A field of the newest message of a topic.
struct FieldRow {
    QString path, value;
    int depth = 0;
    bool number = false;  ///< whether it can be plotted
    friend bool operator==(const FieldRow&, const FieldRow&) = default;
};

/// Fields as rows of a table; those of an inner type are indented.
class FieldRowsModel final : public TextRowsModel {
    Q_OBJECT
public:
    enum Column { Field, Value, Columns };
    using TextRowsModel::TextRowsModel;

    void show(const std::vector<FieldRow>& rows);
    [[nodiscard]] const std::vector<FieldRow>& rows() const { return m_rows; }

protected:
    [[nodiscard]] int rowsInAll() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] QStringList headers() const override;
    [[nodiscard]] QString cell(int row, int column) const override;
    [[nodiscard]] QString hint(int row) const override;

private:
    std::vector<FieldRow> m_rows;
};

/// What is said above the fields of a topic: "10.0 Hz · 0.012 Mbit/s · 35 ms ago", or that nothing came.
/// @p age: of the newest message [s]; empty: none came.
[[nodiscard]] QString topicSummary(double rate, double megabits, std::optional<double> age);

}  // namespace leitstand
