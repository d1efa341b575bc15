#pragma once

#include <cstdint>
#include <vector>

#include <QAbstractTableModel>
#include <QString>

#include "core/robot/link/link_status.h"
#include "core/robot/streams/stream_request.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// One stream of one robot, and the wishes for it.
struct StreamRow {
    RobotFace face;
    StreamStatus stream;
    QString type;             ///< "PointCloud2"
    StreamRequest own;        ///< of the operator
    StreamRequest effective;  ///< after the limits of a thin link
    bool settable = false;    ///< the robot accepts wishes for it
};

/// Returns the name of a stream after its robot's letter: "K left pictures".
[[nodiscard]] QString streamNameText(const StreamRow& row);
/// Returns the rate as received and as sent: "12.0 / 15 Hz"; "on change" when it has no rate.
[[nodiscard]] QString streamRateText(const StreamStatus& stream);
/// Returns the wish: "5 Hz, quality 40, 320 px", "off"; empty: as the robot likes.
[[nodiscard]] QString requestText(const StreamRequest& requested);
/// Returns the text of the setting column: the wish, what a thin link makes of it ("thin: 5 Hz"), and that
/// the robot does not follow it.
[[nodiscard]] QString settingText(const StreamRow& row);
/// Loud when a stream is stale or loses samples without a request to be slow.
[[nodiscard]] Tone toneOf(const StreamRow& row);
/// Returns the total of all robots: "5.6 Mbit/s"; with the budget of a thin link: "1.8 of 2.0 Mbit/s".
[[nodiscard]] QString linkTotalText(double megabits, bool thin, double budget);

/// Streams of all robots, a row each. Rows that stay the same keep their selection.
class StreamTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Type, Rate, Age, Load, Loss, Setting, ColumnCount };
    enum class Of : std::uint8_t {
        Link,  ///< as it arrives now
        Log,   ///< as it was recorded: a log holds neither what never arrived nor the load on the link
    };

    explicit StreamTable(Of of = Of::Link, QObject* parent = nullptr)
        : QAbstractTableModel(parent), m_of(of) {}

    void setRows(std::vector<StreamRow> rows);
    [[nodiscard]] const StreamRow* row(int number) const;  ///< null: there is none

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] static QString text(const StreamRow& row, Column column);

    Of m_of;
    std::vector<StreamRow> m_rows;
};

}  // namespace leitstand
