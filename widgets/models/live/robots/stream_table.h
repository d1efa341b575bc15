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

/// One stream of one robot, and the requests for it.
struct StreamRow {
    RobotFace face;
    StreamStatus stream;
    QString type;             ///< "PointCloud2"
    StreamRequest own;        ///< request of the operator
    StreamRequest effective;  ///< request after the limits of a thin link
    bool settable = false;    ///< whether the robot accepts requests for this stream
    bool mayMap = false;  ///< whether it is one of several clouds of the robot, of which one makes the map
    bool maps = false;    ///< whether it makes the map
};

/// Returns the letter of the robot and the name of the stream: "K left pictures".
[[nodiscard]] QString streamNameText(const StreamRow& row);
/// Returns the rate as received and as sent [Hz]: "12 / 15". "on change" for a stream without a steady rate,
/// "off" while it is switched off, a dash before the first sample.
[[nodiscard]] QString streamRateText(const StreamStatus& stream);
/// Returns the text of a request: "5 Hz, quality 40, 320 px", "off". Empty: the robot may choose everything.
[[nodiscard]] QString requestText(const StreamRequest& requested);
/// Returns the text of the setting column: the request in effect. It begins with "thin:" if a thin link
/// limits the request, and ends with "not yet" while the robot does not follow it.
[[nodiscard]] QString settingText(const StreamRow& row);
/// Returns Attention when the stream is stale or loses more than 2 % of its samples. Returns Muted when it is
/// switched off or nothing was received yet.
[[nodiscard]] Tone toneOf(const StreamRow& row);
/// Returns the total of all robots: "5.6 Mbit/s"; with the budget of a thin link: "1.8 of 2.0 Mbit/s".
[[nodiscard]] QString linkTotalText(double megabits, bool thin, double budget);

/// Streams of all robots, one row each. The selection is kept as long as the rows are about the same streams.
class StreamTable final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Type, Rate, Age, Load, Loss, Setting, ColumnCount };
    enum class Of : std::uint8_t {
        Link,  ///< streams as they are received now
        Log,   ///< streams as recorded, without load, loss and setting, which a log does not have
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
