#pragma once

#include <vector>

#include <QAbstractListModel>
#include <QTime>

namespace leitstand {

/// What the operator was told, newest last.
class MessageListModel final : public QAbstractListModel {
    Q_OBJECT
public:
    enum class Severity { Warning, Error };

    using QAbstractListModel::QAbstractListModel;

    /// Adds a message with the present time of day. The same text is not repeated while it stands in the
    /// list; beyond 500 the oldest go. Several lines become one, with dots between.
    void add(Severity severity, const QString& said);
    /// Adds a warning; where the same text stands already, it goes to the end with the present time.
    void tell(const QString& said);
    /// Takes the message of @p row away.
    void dismiss(int row);
    void clear();
    /// How many errors stand in the list; the rest are warnings.
    [[nodiscard]] int errorCount() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    struct Message {
        Severity severity;
        QTime at;
        QString text;
    };
    std::vector<Message> m_messages;
};

}  // namespace leitstand
